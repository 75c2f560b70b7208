// Who is asked whether long work goes on. `with Watch(progress)` of Python has `progress` asked by the core's long
// calls within, and by Python's own functions of PatchMill: the interpreter tells each call of a function
// (PyEval_SetProfile), and where the last question is old enough one is asked there.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"

#include <chrono>
#include <cstring>
#include <locale.h>

#include <pybind11/eval.h>

namespace patchmill {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPeriod(30);  // between two questions within Python's functions

/// Whose progress is asked in this thread: the innermost `with Watch(...)`.
thread_local std::vector<class Watch*> watches;
thread_local Clock::time_point last_asked;
thread_local const class Watch* looks = nullptr;  // the one that has the interpreter tell of calls

/// A progress that knows what it was told last, and that it has said no. One without a progress asks the one around it.
class Watch {
 public:
  explicit Watch(py::object progress) : progress_(std::move(progress)) {
    if (has_own() && !PyCallable_Check(progress_.ptr()))
      throw InputError("Progress", py::str(progress_),
                       "give a function of the share done, or None.");
  }

  void begin() {
    around_ = watches.empty() ? nullptr : watches.back();
    watches.push_back(this);
  }
  void end() { watches.pop_back(); }

  /// Keeps the share done; whether to go on.
  bool tell(double share) {
    share_ = share;
    return goes_on();
  }

  bool goes_on() {
    if (!has_own()) return around_ == nullptr || around_->goes_on();
    if (stopped_) return false;
    last_asked = Clock::now();
    stopped_ = !progress_(share_).cast<bool>();
    return !stopped_;
  }

  bool has_own() const { return !progress_.is_none(); }
  bool asks() const { return has_own() || (around_ != nullptr && around_->asks()); }
  bool stopped() const {
    return stopped_ || (!has_own() && around_ != nullptr && around_->stopped());
  }

 private:
  py::object progress_;
  Watch* around_ = nullptr;
  double share_ = 0.0;
  bool stopped_ = false;
};

[[noreturn]] void raise_cancelled() {
  PyErr_SetNone(py::module_::import("_patchmill").attr("Cancelled").ptr());
  throw py::error_already_set();
}

// Whether a function is one of PatchMill's: others are not ended in the middle of what they do.
bool is_ours(PyFrameObject* frame) {
  const auto code =
      py::reinterpret_steal<py::object>(reinterpret_cast<PyObject*>(PyFrame_GetCode(frame)));
  const char* file = PyUnicode_AsUTF8(reinterpret_cast<PyCodeObject*>(code.ptr())->co_filename);
  if (file == nullptr) PyErr_Clear();  // a name that is no text
  return file != nullptr && (std::strstr(file, "/patchmill/") != nullptr ||
                             std::strstr(file, "\\patchmill\\") != nullptr);  // on Windows
}

// Told by the interpreter of each call of a function. Once stopped, what is cleaned up on the way out is let alone.
int look(PyObject*, PyFrameObject* frame, int what, PyObject*) {
  if (what != PyTrace_CALL || watches.empty() || watches.back()->stopped()) return 0;
  if (Clock::now() - last_asked < kPeriod || !is_ours(frame)) return 0;
  try {
    if (!watches.back()->goes_on()) raise_cancelled();
    return 0;
  } catch (py::error_already_set& error) {
    error.restore();
    return -1;
  }
}

// Has the interpreter tell of calls, unless somebody else (a profiler) is told already.
void begin_to_look(const Watch* watch) {
  if (looks != nullptr || !watch->has_own()) return;
  if (!py::module_::import("sys").attr("getprofile")().is_none()) return;
  looks = watch;
  PyEval_SetProfile(&look, nullptr);
}

void look_no_more(const Watch* watch) {
  if (looks != watch) return;
  PyEval_SetProfile(nullptr, nullptr);
  looks = nullptr;
}

}  // namespace

void bind_watch(py::module_& m) {
  py::exec(R"(
class Cancelled(BaseException):
    """Ends what is done within `with Watch(progress)` when `progress` returned False; goes no further. No fault, and
    so no Exception: nothing that handles faults on the way takes it for one."""
)",
           m.attr("__dict__"));
  m.attr("Cancelled").attr("__module__") = "_patchmill";
  py::class_<Watch>(m, "Watch",
                    "with Watch(progress) as progress: all long calls within also ask `progress` "
                    "(share -> bool), and the block ends where it returns False. Watch(None) asks "
                    "the one around it, which ends then.")
      .def(py::init<py::object>(), py::arg("progress") = py::none(),
           "Raises InputError naming Progress.")
      .def(
          "__call__",
          [](Watch& watch, double share) {
            if (watch.tell(share)) return true;
            if (!watch.has_own()) raise_cancelled();
            return false;
          },
          py::arg("share"),
          "Tells the share done, 0 to 1; whether to go on. Raises what the progress raises, and "
          "Cancelled where it is that of a Watch around this one that says no.")
      .def(
          "__enter__",
          [](Watch& watch) -> Watch& {
            watch.begin();
            begin_to_look(&watch);
            return watch;
          },
          py::return_value_policy::reference, "Begins to be asked in this thread. Raises nothing.")
      .def(
          "__exit__",
          [](Watch& watch, const py::object& type, const py::object&, const py::object&) {
            look_no_more(&watch);
            watch.end();
            return watch.has_own() && watch.stopped() &&
                   type.is(py::module_::import("_patchmill").attr("Cancelled"));
          },
          "Ends it, and Cancelled with it if its own progress said no. Raises nothing.");
}

bool watched(const py::object& callable, const std::function<void(const Progress&)>& work) {
  std::optional<py::error_already_set> raised;
  const locale_t numbers =
      uselocale(nullptr);  // of this thread: the work's own writes numbers alike
  bool done = false;
  {
    const py::gil_scoped_release release;
    done = run_stoppable(
        [&](const Progress& progress) {
          uselocale(numbers);
          work(progress);
        },
        [&](double share) {
          const py::gil_scoped_acquire gil;
          try {
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
            if (!callable.is_none()) return callable(share).cast<bool>();
            if (watches.empty() || watches.back()->goes_on()) return true;
            raise_cancelled();
          } catch (py::error_already_set& error) {
            raised.emplace(std::move(error));
            return false;
          }
        });
  }
  if (raised) throw py::error_already_set(std::move(*raised));
  return done;
}

}  // namespace patchmill
