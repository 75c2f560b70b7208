// What the binding files share. Bindings convert and check arguments, release the GIL in long
// calls, and hold no algorithm.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"
#include "patchmill/geometry/vec.h"
#include "patchmill/patch/helix.h"

#include <functional>
#include <optional>
#include <type_traits>

#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace patchmill {

namespace py = pybind11;

void bind_errors(py::module_& m);
void bind_path(py::module_& m);
void bind_patch(py::module_& m);
void bind_rows(py::module_& m);
void bind_dimples_at(py::module_& m);
void bind_mesh(py::module_& m);
void bind_texture(py::module_& m);
void bind_atlas(py::module_& m);
void bind_matsuda(py::module_& m);
void bind_brep(py::module_& m);
void bind_sync(py::module_& m);
void bind_machine(py::module_& m);
void bind_machine_model(py::module_& m);
void bind_kinematics(py::module_& m);
void bind_postures(py::module_& m);
void bind_scene(py::module_& m);
void bind_solids(py::module_& m);
void bind_dcm(py::module_& m);
void bind_dcm_path(py::module_& m);
void bind_load(py::module_& m);
void bind_voxel_attributes(py::module_& m);
void bind_marks(py::module_& m);
void bind_dales(py::module_& m);
void bind_checks(py::module_& m);

/// An (n, 3) array of `get(item)` for each item.
template <class Items, class Get>
py::array_t<double> rows_of(const Items& items, Get get) {
  py::array_t<double> array({static_cast<py::ssize_t>(items.size()), py::ssize_t{3}});
  auto out = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < out.shape(0); ++i) {
    const Vec3 v = get(items[static_cast<std::size_t>(i)]);
    for (py::ssize_t k = 0; k < 3; ++k) out(i, k) = v[k];
  }
  return array;
}

/// An (n,) array of `get(item)` for each item.
template <class T, class Items, class Get>
py::array_t<T> column_of(const Items& items, Get get) {
  py::array_t<T> array(static_cast<py::ssize_t>(items.size()));
  auto out = array.template mutable_unchecked<1>();
  for (py::ssize_t i = 0; i < out.shape(0); ++i) out(i) = get(items[static_cast<std::size_t>(i)]);
  return array;
}

/// The value of the choice named `given`. Errors: InputError naming `property`, with all choices.
template <class T>
T choose(const char* property, const std::string& given,
         const std::vector<std::pair<const char*, T>>& choices) {
  std::string all;
  for (const auto& [text, value] : choices) {
    if (given == text) return value;
    all += (all.empty() ? "" : ", ") + std::string(text);
  }
  throw InputError(property, "'" + given + "'", "give one of: " + all + ".");
}

/// Makes the Python enum.IntEnum `name` in a module: numbers in arrays compare with its members, and its members
/// go where an int goes. `text`: its docstring.
void bind_numbers(py::module_& m, const char* name, const char* text,
                  const std::vector<std::pair<const char*, int>>& members);

/// As bind_numbers, for an enumeration of the core.
template <class E>
void bind_enum(py::module_& m, const char* name, const char* text,
               const std::vector<std::pair<const char*, E>>& members) {
  std::vector<std::pair<const char*, int>> numbers;
  for (const auto& [member, value] : members) numbers.emplace_back(member, static_cast<int>(value));
  bind_numbers(m, name, text, numbers);
}

/// "Square", "Hexagon" or "Triangle".
patch::PatchShape shape_of(const std::string& name);

/// Does long work without the GIL in a thread of its own (stop.h), while this one looks for Ctrl-C and tells
/// `callable` (share -> bool, or None) how far it is, at least each 100 ms. False if the callable returned False: what
/// the work made is not whole then. Without a callable the innermost Watch of this thread is asked, and Cancelled is
/// raised if it says no. What the callable raises, and KeyboardInterrupt, is raised after the work's end.
bool watched(const py::object& callable, const std::function<void(const Progress&)>& work);

/// A function that takes and gives nothing of Python's as one that Ctrl-C ends, and a Watch around it, without the
/// GIL.
template <class Function, class Result, class... Arguments>
auto interruptible_as(Function function, Result (Function::*)(Arguments...) const) {
  return [function](Arguments... arguments) -> Result {
    if constexpr (std::is_void_v<Result>) {
      watched(py::none(), [&](const Progress&) { function(arguments...); });
    } else {
      std::optional<Result> result;
      watched(py::none(), [&](const Progress&) {
        result.emplace(function(std::forward<Arguments>(arguments)...));
      });
      return std::move(*result);
    }
  };
}
template <class Function>
auto interruptible(Function function) {
  return interruptible_as(function, &Function::operator());
}
template <class Result, class... Arguments>
auto interruptible(Result (*function)(Arguments...)) {
  return interruptible([function](Arguments... arguments) -> Result {
    return function(std::forward<Arguments>(arguments)...);
  });
}

}  // namespace patchmill

// Dimples stays one opaque object: arrays cross as numpy, never as Python lists.
PYBIND11_MAKE_OPAQUE(patchmill::patch::Dimples)
