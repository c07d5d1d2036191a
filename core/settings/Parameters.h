// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace core::settings {

/// A number that a user may read or change while the program runs. The owner of the number provides the functions; one
/// that concerns the servo is sent there as a command by `write`, and read back from what was sent.
struct Parameter
{
    std::string name;  ///< "force.stiffness": the group before the first point; unique
    std::string unit;  ///< empty: no unit
    double minimum = 0.0;
    double maximum = 1.0;
    bool isSwitch = false;            ///< 0 or 1
    std::function<double()> read;     ///< cheap; NaN if there is no value
    std::function<double()> initial;  ///< returns the value that reset() sets; null: read-only
    /// Sets the value; returns why not, in the language of the window, or an empty string. Null: a live value, which
    /// can only be watched.
    std::function<std::string(double)> write;
    std::function<std::string()> label;  ///< "Stiffness", in the language of the window
    std::function<std::string()> help;   ///< explanation, in the same language
    /// Returns why the value is hidden at present, in the same language, or an empty string; `read` then returns NaN.
    /// Null: never hidden.
    std::function<std::string()> withheld{};

    [[nodiscard]] bool isLive() const { return !write; }
};

/// The outcome of setting a parameter.
struct SetAnswer
{
    enum class Outcome { Done, Unknown, ReadOnly, NotANumber, OutOfRange, Refused };
    Outcome outcome = Outcome::Done;
    std::string why;  ///< for Refused: the owner's sentence
};

/// All parameters by name, for the console, the settings page and tests. Ui thread.
class Parameters
{
public:
    /// Adds a parameter, or replaces the one of the same name.
    void add(Parameter parameter);

    /// Returns a parameter; null if there is none. Valid until the name is added again.
    [[nodiscard]] const Parameter* find(std::string_view name) const;
    /// Returns the parameters whose name contains the text, sorted by name; empty text: all.
    [[nodiscard]] std::vector<const Parameter*> matching(std::string_view text) const;
    /// Returns the parameters whose name begins with the text.
    [[nodiscard]] std::vector<const Parameter*> beginningWith(std::string_view text) const;

    [[nodiscard]] SetAnswer set(std::string_view name, double value) const;
    /// Sets a parameter to its initial value.
    [[nodiscard]] SetAnswer reset(std::string_view name) const;

private:
    std::vector<std::unique_ptr<const Parameter>> m_all;  ///< by name
};

}  // namespace core::settings
