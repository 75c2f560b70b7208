// Scene graphs as Open Inventor 2.1 binary files, which every Coin reads (SoDB::readAll), so that nothing here links
// a Coin of its own: two in one process do not get on, and their sonames differ from one FreeCAD to the next.
//
// The form: words of four bytes, most significant first; a string is its length and its bytes, filled up to whole
// words. A node is its type, its flags, the number of its fields, the fields (name, value, flags), and for a group the
// number of its children and the children. A field of several values is their number and the values; one of an
// enumeration is the value's name; one of a node is the node. J. Wernecke, The Inventor Mentor, 1994, chapter 11.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace patchmill::scene {

using Point3f = std::array<float, 3>;

/// A node that is being written. Fields of arrays are empty or are given whole.
class InventorNode {
 public:
  /// `type` as in a file, without So: "Separator". Children can be added to a group only.
  explicit InventorNode(std::string_view type) : type_(type) {}

  InventorNode& number(std::string_view field, float value);
  InventorNode& name(std::string_view field, std::string_view of_enumeration);
  InventorNode& node(std::string_view field, const InventorNode& value);
  InventorNode& numbers(std::string_view field, const std::vector<float>& values);
  InventorNode& integers(std::string_view field, const std::vector<std::int32_t>& values);
  InventorNode& colours(std::string_view field, const std::vector<std::uint32_t>& rgba);
  InventorNode& points(std::string_view field, const std::vector<Point3f>& values);
  /// Adds a child, which makes this a group.
  InventorNode& child(const InventorNode& node);
  /// Makes this a group, though it may stay without a child.
  InventorNode& group();

  /// The file with this node as its root.
  std::string file() const;

 private:
  void append_to(std::string& out) const;
  std::string& begin(std::string_view field);
  template <class Values>
  InventorNode& words(std::string_view field, const Values& values);

  std::string type_, fields_, children_;
  std::uint32_t field_count_ = 0, child_count_ = 0;
  bool is_group_ = false;
};

}  // namespace patchmill::scene
