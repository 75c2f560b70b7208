// A reader that is written in Python under libFuzzer: the function READER of readers.py, called with any bytes. What
// it raises ends the process. Each step from a line of PatchMill's to the next counts for libFuzzer as a way of the
// program does, by its extra counters, so that inputs that reach what no other does are kept.
// SPDX-License-Identifier: LGPL-2.1-or-later
#define PY_SSIZE_T_CLEAN
#include <Python.h>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <frameobject.h>
#include <string>
#include <string_view>
#include <unordered_map>

namespace {

constexpr std::size_t kCounters = 1 << 16;
__attribute__((used, section("__libfuzzer_extra_counters"))) std::array<std::uint8_t, kCounters>
    counters;

PyObject* reader = nullptr;

// A number of a piece of code that is PatchMill's, 0 of any other.
std::size_t number_of(PyCodeObject* code) {
  static std::unordered_map<PyCodeObject*, std::size_t> known;
  const auto found = known.find(code);
  if (found != known.end()) return found->second;
  const char* file = PyUnicode_AsUTF8(code->co_filename);
  if (file == nullptr) PyErr_Clear();
  const std::string_view name(file == nullptr ? "" : file);
  const bool ours = name.find("/patchmill/") != std::string_view::npos;
  Py_INCREF(code);  // no other code is to have its address
  return known[code] = ours ? std::hash<std::string>()(std::string(name)) % kCounters + 1 : 0;
}

int trace(PyObject*, PyFrameObject* frame, int what, PyObject*) {
  static std::size_t before = 0;
  if (what != PyTrace_LINE) return 0;
  PyCodeObject* code = PyFrame_GetCode(frame);
  if (const std::size_t number = number_of(code)) {
    const std::size_t here = number + 31 * static_cast<std::size_t>(PyFrame_GetLineNumber(frame));
    ++counters[(here ^ (before << 5)) % kCounters];
    before = here;
  }
  Py_DECREF(code);
  return 0;
}

void require(bool good) {
  if (good) return;
  PyErr_Print();
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  Py_InitializeEx(0);
  require(PyRun_SimpleString("import sys; sys.path.insert(0, '" READERS "')") == 0);
  PyObject* readers = PyImport_ImportModule("readers");
  require(readers != nullptr);
  reader = PyObject_GetAttrString(readers, READER);
  require(reader != nullptr);
  std::atexit([] { Py_Finalize(); });  // its own ends: the folder of readers.py
  PyEval_SetTrace(trace, nullptr);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  PyObject* answer = PyObject_CallFunction(reader, "y#", reinterpret_cast<const char*>(data),
                                           static_cast<Py_ssize_t>(size));
  require(answer != nullptr);
  Py_DECREF(answer);
  return 0;
}
