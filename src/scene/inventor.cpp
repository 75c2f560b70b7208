// Writing Open Inventor 2.1 binary files; see inventor.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/inventor.h"

#include <cstring>

namespace patchmill::scene {
namespace {

constexpr std::string_view kHeader = "#Inventor V2.1 binary  \n";
constexpr std::uint32_t kNoFlags = 0, kGroup = 2;  // of a node; those of a field are 0

void put(std::string& out, std::uint32_t word) {
  const std::array<char, 4> bytes{static_cast<char>(word >> 24), static_cast<char>(word >> 16),
                                  static_cast<char>(word >> 8), static_cast<char>(word)};
  out.append(bytes.data(), bytes.size());
}

void put(std::string& out, std::int32_t number) {
  put(out, static_cast<std::uint32_t>(number));
}

void put(std::string& out, float number) {
  static_assert(sizeof(float) == 4, "an Inventor file has numbers of four bytes");
  std::uint32_t word = 0;
  std::memcpy(&word, &number, sizeof(word));
  put(out, word);
}

void put(std::string& out, const Point3f& point) {
  for (const float coordinate : point) put(out, coordinate);
}

void put(std::string& out, std::string_view text) {
  put(out, static_cast<std::uint32_t>(text.size()));
  out.append(text);
  out.append((4 - text.size() % 4) % 4, '\0');
}

}  // namespace

std::string& InventorNode::begin(std::string_view field) {
  if (field_count_++ > 0) put(fields_, kNoFlags);  // ends the field before
  put(fields_, field);
  return fields_;
}

InventorNode& InventorNode::number(std::string_view field, float value) {
  put(begin(field), value);
  return *this;
}

InventorNode& InventorNode::name(std::string_view field, std::string_view of_enumeration) {
  put(begin(field), of_enumeration);
  return *this;
}

InventorNode& InventorNode::node(std::string_view field, const InventorNode& value) {
  value.append_to(begin(field));
  return *this;
}

template <class Values>
InventorNode& InventorNode::words(std::string_view field, const Values& values) {
  std::string& out = begin(field);
  out.reserve(out.size() + sizeof(typename Values::value_type) * values.size() + 64);
  put(out, static_cast<std::uint32_t>(values.size()));
  for (const auto& value : values) put(out, value);
  return *this;
}

InventorNode& InventorNode::numbers(std::string_view field, const std::vector<float>& values) {
  return words(field, values);
}

InventorNode& InventorNode::integers(std::string_view field,
                                     const std::vector<std::int32_t>& values) {
  return words(field, values);
}

InventorNode& InventorNode::colours(std::string_view field,
                                    const std::vector<std::uint32_t>& rgba) {
  return words(field, rgba);
}

InventorNode& InventorNode::points(std::string_view field, const std::vector<Point3f>& values) {
  return words(field, values);
}

InventorNode& InventorNode::child(const InventorNode& node) {
  is_group_ = true;
  ++child_count_;
  node.append_to(children_);
  return *this;
}

InventorNode& InventorNode::group() {
  is_group_ = true;
  return *this;
}

void InventorNode::append_to(std::string& out) const {
  put(out, type_);
  put(out, is_group_ ? kGroup : kNoFlags);
  put(out, field_count_);
  out.append(fields_);
  if (field_count_ > 0) put(out, kNoFlags);
  if (!is_group_) return;
  put(out, child_count_);
  out.append(children_);
}

std::string InventorNode::file() const {
  std::string out;
  out.reserve(fields_.size() + children_.size() + 128);
  out.append(kHeader);
  append_to(out);
  return out;
}

}  // namespace patchmill::scene
