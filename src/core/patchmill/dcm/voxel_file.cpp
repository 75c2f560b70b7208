// Writing and reading the voxel model; see voxel_file.h. Layout: magic, key, frame, bricks of the box that
// are stored or solid, kinds, posture, materials, a sum
// of it all. Numbers as the machine has them: the file is a cache.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/dcm/voxel_file.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace patchmill::dcm {
namespace {

constexpr std::uint64_t kMagic = 0x33764d5064746f4dULL;

// Mixes bytes into a sum, eight at a time: a file that was damaged gives another one.
std::uint64_t mixed(std::uint64_t sum, const char* bytes, std::size_t count) {
  for (std::size_t at = 0; at < count; at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes + at, std::min<std::size_t>(8, count - at));
    sum = (sum ^ word) * 0x9e3779b97f4a7c15ULL;
    sum ^= sum >> 29;
  }
  return sum;
}

struct Writer {
  std::ostream& out;
  std::uint64_t sum = 0;
  void bytes(const void* from, std::size_t count) {
    out.write(static_cast<const char*>(from), static_cast<std::streamsize>(count));
    sum = mixed(sum, static_cast<const char*>(from), count);
  }
};

struct Reader {
  std::istream& in;
  std::uint64_t left =
      0;  ///< bytes of the file that have not been read: what it says of itself may be false
  std::uint64_t sum = 0;
  explicit operator bool() const { return bool(in); }
  void bytes(void* to, std::size_t count) {
    if (count > left) in.setstate(std::ios::failbit);
    left -= std::min<std::uint64_t>(left, count);
    in.read(static_cast<char*>(to), static_cast<std::streamsize>(count));
    if (in) sum = mixed(sum, static_cast<const char*>(to), count);
  }
};

template <class T>
void put(Writer& out, const T& value) {
  out.bytes(&value, sizeof value);
}

template <class T>
void put_all(Writer& out, const std::vector<T>& values) {
  put(out, std::uint64_t{values.size()});
  out.bytes(values.data(), values.size() * sizeof(T));
}

template <class T>
T get(Reader& in) {
  T value{};
  in.bytes(&value, sizeof value);
  return value;
}

// False unless exactly `count` values follow.
template <class T>
bool get_all(Reader& in, std::size_t count, std::vector<T>& values) {
  if (get<std::uint64_t>(in) != count || !in || count > in.left / sizeof(T)) return false;
  values.resize(count);
  in.bytes(values.data(), count * sizeof(T));
  return bool(in);
}

std::vector<std::uint8_t> stored_bricks(const voxel::BrickTable& table) {
  std::vector<std::uint8_t> wanted;
  wanted.reserve(table.at.size());
  for (const std::int32_t number : table.at) wanted.push_back(number == voxel::kNoBrick ? 0 : 1);
  return wanted;
}

bool read_grid(Reader& in, voxel::VoxelGrid& grid) {
  for (int k = 0; k < 3; ++k) grid.frame.origin[k] = get<double>(in);
  grid.frame.pitch = get<double>(in);
  for (int k = 0; k < 3; ++k) grid.frame.cells[k] = get<std::int32_t>(in);
  const bool sane = in && grid.frame.pitch > 0.0 && (grid.frame.cells.array() > 0).all() &&
                    (grid.frame.cells.array() <= 32768).all();
  if (!sane) return false;
  const voxel::Cell box = voxel::brick_box(grid.frame.cells);
  const std::size_t bricks = static_cast<std::size_t>(box.x()) * box.y() * box.z();
  std::vector<std::uint8_t> wanted;
  if (!get_all(in, bricks, wanted) || !get_all(in, bricks, grid.solid_bricks)) return false;
  grid.table = voxel::make_brick_table(grid.frame.cells, wanted);
  if (!get_all(in, grid.table.cell_count(), grid.kind)) return false;
  return std::all_of(grid.kind.begin(), grid.kind.end(), [](voxel::VoxelKind kind) {
    return static_cast<int>(kind) < voxel::kVoxelKinds;
  });
}

bool read_posture(Reader& in, std::size_t cells, VoxelModel& model) {
  const auto fields = get<std::uint32_t>(in);
  if (!in || (fields != 0 && fields != 2 && fields != 3)) return false;
  if (fields == 0) return true;
  PostureField posture;
  posture.form = fields == 2 ? PostureForm::Angles : PostureForm::UnitVector;
  posture.outcome.converged = true;
  posture.outcome.iterations = get<std::int32_t>(in);
  posture.outcome.true_residual = get<double>(in);
  posture.value.resize(fields);
  for (auto& field : posture.value)
    if (!get_all(in, cells, field)) return false;
  model.posture = std::move(posture);
  return true;
}

bool read_materials(Reader& in, std::size_t cells, VoxelModel& model) {
  const auto there = get<std::uint8_t>(in);
  if (!in || there > 1) return false;
  return there == 0 || get_all(in, cells, model.material);
}

void write_all(Writer& out, const std::string& key, const VoxelModel& model) {
  const voxel::VoxelGrid& grid = model.grid;
  put(out, kMagic);
  put_all(out, std::vector<char>(key.begin(), key.end()));
  for (int k = 0; k < 3; ++k) put(out, double{grid.frame.origin[k]});
  put(out, grid.frame.pitch);
  for (int k = 0; k < 3; ++k) put(out, std::int32_t{grid.frame.cells[k]});
  put_all(out, stored_bricks(grid.table));
  put_all(out, grid.solid_bricks);
  put_all(out, grid.kind);
  put(out, static_cast<std::uint32_t>(model.posture ? model.posture->value.size() : 0));
  if (model.posture) {
    put(out, std::int32_t{model.posture->outcome.iterations});
    put(out, model.posture->outcome.true_residual);
    for (const auto& field : model.posture->value) put_all(out, field);
  }
  put(out, static_cast<std::uint8_t>(model.material.empty() ? 0 : 1));
  if (!model.material.empty()) put_all(out, model.material);
  put(out, std::uint64_t{out.sum});
}

}  // namespace

void write_voxel_model(const std::string& path, const std::string& key, const VoxelModel& model) {
  std::ofstream out(path, std::ios::binary);
  Writer writer{out};
  if (out) write_all(writer, key, model);
  out.close();
  if (!out)
    throw InputError("voxel file", path, "it could not be written: make room or choose a folder.");
}

std::optional<VoxelModel> read_voxel_model(const std::string& path, const std::string& key) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown))
    return std::nullopt;  // a pipe would be waited for
  std::ifstream file(path, std::ios::binary);
  file.seekg(0, std::ios::end);
  const auto size = static_cast<std::int64_t>(file.tellg());
  file.seekg(0);
  Reader in{file, size > 0 ? static_cast<std::uint64_t>(size) : 0};
  if (!in || get<std::uint64_t>(in) != kMagic) return std::nullopt;
  std::vector<char> found;
  if (!get_all(in, key.size(), found) || std::string(found.begin(), found.end()) != key)
    return std::nullopt;
  VoxelModel model;
  if (!read_grid(in, model.grid)) return std::nullopt;
  if (!read_posture(in, model.grid.kind.size(), model)) return std::nullopt;
  if (!read_materials(in, model.grid.kind.size(), model)) return std::nullopt;
  const std::uint64_t sum = in.sum;
  if (get<std::uint64_t>(in) != sum || !in) return std::nullopt;
  return model;
}

}  // namespace patchmill::dcm
