// The compiled module's entry, its errors and its progress callbacks.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "core/geometry/error.h"

#include <pybind11/eval.h>
#include <tbb/global_control.h>

namespace patchmill {

void bind_errors(py::module_& m) {
  py::exec(R"(
class InputError(ValueError):
    """Bad input: names the property, its value and the remedy."""

    def __init__(self, property, value, remedy):
        super().__init__("%s = %s: %s" % (property, value, remedy))
        self.property = property
        self.value = value
        self.remedy = remedy
)",
           m.attr("__dict__"));
  m.attr("InputError").attr("__module__") = "_patchmill";
  py::register_exception_translator([](std::exception_ptr p) {
    try {
      if (p) std::rethrow_exception(p);
    } catch (const InputError& e) {
      const py::object type = py::module_::import("_patchmill").attr("InputError");
      const py::object error = type(e.property(), e.value(), e.remedy());
      PyErr_SetObject(type.ptr(), error.ptr());
    }
  });
}

void bind_threads(py::module_& m) {
  using Control = tbb::global_control;
  py::class_<Control>(m, "ThreadLimit", "While it lives, no more threads than this are used.")
      .def(py::init([](std::size_t threads) {
             if (threads == 0) throw InputError("Threads", "0", "give at least one.");
             return std::make_unique<Control>(Control::max_allowed_parallelism, threads);
           }),
           py::arg("threads"));
}

Progress progress_of(const py::object& callable) {
  if (callable.is_none()) return {};
  return [callable](double share) {
    const py::gil_scoped_acquire gil;
    return callable(share).cast<bool>();
  };
}

}  // namespace patchmill

PYBIND11_MODULE(_patchmill, m) {
  m.attr("__version__") = PATCHMILL_VERSION;
  m.doc() = "PatchMill's core: patches, phase, marks. mm, s, radians, revolutions per second.";
  patchmill::bind_errors(m);
  patchmill::bind_threads(m);
  patchmill::bind_path(m);
  patchmill::bind_patch(m);
  patchmill::bind_brep(m);
  patchmill::bind_texture(m);
  patchmill::bind_matsuda(m);
  patchmill::bind_sync(m);
  patchmill::bind_machine(m);
  patchmill::bind_kinematics(m);
  patchmill::bind_machine_model(m);
  patchmill::bind_postures(m);
  patchmill::bind_scene(m);
  patchmill::bind_dcm(m);
  patchmill::bind_dcm_path(m);
  patchmill::bind_voxel_attributes(m);
  patchmill::bind_marks(m);
  patchmill::bind_checks(m);
}
