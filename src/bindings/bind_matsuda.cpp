// Matsuda's free form and the advisor for Python. Phases in teeth; mm, mm/s, revolutions per second.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "core/patch/advisor.h"

namespace patchmill {
namespace {

MarkWish wish_of(const BallEndMill& tool, double spindle_speed, const std::string& shape,
                 double side, const std::string& array, std::optional<double> feed_per_tooth,
                 std::optional<double> ridge_height, std::optional<double> cross_feed) {
  MarkWish wish;
  wish.tool = tool;
  wish.spindle_speed = spindle_speed;
  wish.corners = corners(shape_of(shape));
  wish.side = side;
  wish.array = choose<MarkArray>(
      "MarkArray", array, {{"Square", MarkArray::Square}, {"Staggered", MarkArray::Staggered}});
  wish.feed_per_tooth = feed_per_tooth;
  wish.ridge_height = ridge_height;
  wish.cross_feed = cross_feed;
  return wish;
}

py::dict proposal_dict(const FreePatch& wished, const MarkProposal& proposal) {
  py::dict d;
  d["kept"] = name(proposal.kept);
  d["side"] = proposal.patch.side;
  d["cross_feed"] = proposal.patch.cross_feed;
  d["feed_per_tooth"] = proposal.patch.feed_per_tooth;
  d["feed"] = proposal.feed;
  d["ridge_height"] = proposal.ridge_height;
  d["state"] = describe(proposal.state);
  d["change"] = proposal.change;
  d["changes"] = describe_changes(wished, proposal);
  return d;
}

py::list advise_list(const MarkWish& wish) {
  const FreePatch wished = wished_patch(wish);
  py::list all;
  for (const MarkProposal& proposal : advise(wish)) all.append(proposal_dict(wished, proposal));
  return all;
}

}  // namespace

void bind_matsuda(py::module_& m) {
  py::class_<MarkWish>(m, "MarkWish", "What the user wants of Matsuda's free form.")
      .def(py::init(&wish_of), py::arg("tool"), py::arg("spindle_speed"), py::arg("shape"),
           py::arg("side"), py::arg("array") = "Square", py::arg("feed_per_tooth") = py::none(),
           py::arg("ridge_height") = py::none(), py::arg("cross_feed") = py::none())
      .def(
          "state", [](const MarkWish& w) { return describe(mark_array(wished_patch(w))); },
          "The array that the wish itself gives, in one sentence.");
  m.def("advise", &advise_list, py::arg("wish"),
        "Aligned patches next to the wish, the one that changes least first: a list of dicts.");
}

}  // namespace patchmill
