// The compiled module's entry and its errors.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "patchmill/geometry/error.h"

#include <pybind11/eval.h>
#include <tbb/global_control.h>

namespace patchmill {

void bind_watch(py::module_& m);  // watch.cpp

namespace {

// A text of an error for Python. It may quote a piece of what was read, and that begin or end within a character.
py::object text_of(const std::string& text) {
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
}

}  // namespace

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
      const py::object error = type(text_of(e.property()), text_of(e.value()), text_of(e.remedy()));
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
           py::arg("threads"),
           "At most so many threads, 1 or more. Raises InputError naming Threads.");
}

void bind_numbers(py::module_& m, const char* name, const char* text,
                  const std::vector<std::pair<const char*, int>>& members) {
  const py::object make = py::module_::import("enum").attr("IntEnum");
  const py::object made = make(name, members, py::arg("module") = m.attr("__name__"));
  made.attr("__doc__") = text;
  m.attr(name) = made;
}

namespace {

using Bind = void (*)(py::module_&);

/// Makes the submodule of a subject. Its names are names of the module itself, too: `_patchmill.ToolPath` is
/// `_patchmill.path.ToolPath`.
void subject(py::module_& module, const char* name, const char* text,
             std::initializer_list<Bind> binds) {
  py::module_ part = module.def_submodule(name, text);
  for (const Bind bind : binds) bind(part);
  for (const auto& [key, value] : part.attr("__dict__").cast<py::dict>())
    if (key.cast<std::string>().rfind("__", 0) != 0) module.attr(key) = value;
}

}  // namespace

}  // namespace patchmill

PYBIND11_MODULE(_patchmill, m) {
  using namespace patchmill;
  m.attr("__version__") = PATCHMILL_VERSION;
  m.doc() =
      "PatchMill's core, a submodule for each subject. mm, s, radians, revolutions per second.";
  bind_errors(m);
  bind_threads(m);
  bind_watch(m);
  subject(m, "path", "Tools, spindles and tool paths.", {bind_path});
  subject(m, "patch", "Patches, lattices, masks and sizes of textures.",
          {bind_patch, bind_dimples_at, bind_rows, bind_mesh, bind_texture});
  subject(m, "brep", "Points and borders of faces.", {bind_brep, bind_atlas});
  subject(m, "machine", "Machines: axes, joints, motion, programs that are written and read.",
          {bind_machine, bind_kinematics, bind_machine_model});
  subject(m, "sync", "Phases of the spindle, free forms, postures of the tool.",
          {bind_matsuda, bind_sync, bind_postures});
  subject(m, "scene", "What displays show.", {bind_scene});
  subject(m, "dcm", "Dynamic contour milling and copy milling.",
          {bind_solids, bind_dcm, bind_dcm_path, bind_load});
  subject(m, "voxel", "What voxels hold: materials, feeds, postures, kinds.",
          {bind_voxel_attributes});
  subject(m, "marks", "Marks that a moved cutter leaves, and how they lie.",
          {bind_marks, bind_dales});
  subject(m, "collision", "Gouges and collisions of a tool along a path.", {bind_checks});
}
