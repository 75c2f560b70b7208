// Typed errors for bad input: each names the property, the value and the remedy, so that a panel
// can show it beside the field and a batch can log it. Outcomes that are not faults are values, not
// errors.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace patchmill {

/// A value that is out of its range, or does not fit the others: what the user has to change.
class InputError : public std::runtime_error {
 public:
  /// `property`: the name that the user knows; `value`: as given; `remedy`: a whole sentence.
  InputError(std::string property, std::string value, std::string remedy)
      : std::runtime_error(property + " = " + value + ": " + remedy),
        property_(std::move(property)),
        value_(std::move(value)),
        remedy_(std::move(remedy)) {}

  /// Name of the value.
  const std::string& property() const { return property_; }
  /// The value with its unit.
  const std::string& value() const { return value_; }
  /// What to do, a sentence.
  const std::string& remedy() const { return remedy_; }

 private:
  std::string property_, value_, remedy_;
};

/// Throws InputError unless `value` is finite and greater than zero. `unit` is for the message
/// only.
void require_positive(const char* property, double value, const char* unit);

/// Throws InputError unless lo <= value <= hi (NaN fails).
void require_in_range(const char* property, double value, double lo, double hi, const char* unit);

}  // namespace patchmill
