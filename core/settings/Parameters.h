// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace core::settings {

/// One number that a person may look at or turn while the program runs. Whoever owns the number binds it: what concerns
/// the servo is sent there as a command by `write`, and read back from what was sent.
struct Parameter
{
    std::string name;  ///< "force.stiffness": its group before the first point; unique
    std::string unit;  ///< empty: a plain number
    double minimum = 0.0;
    double maximum = 1.0;
    bool isSwitch = false;            ///< 0 or 1
    std::function<double()> read;     ///< cheap; NaN where there is nothing to read
    std::function<double()> initial;  ///< what reset() sets; null: it is only read
    /// Sets it; answers why not, in the language of the window, or nothing. Null: a live value, to be watched.
    std::function<std::string(double)> write;
    std::function<std::string()> label;  ///< "Stiffness", in the language of the window
    std::function<std::string()> help;   ///< what it does, in the same
    /// Why it is not told here and now, in the same, or nothing; `read` says NaN meanwhile. Null: it always is told.
    std::function<std::string()> withheld{};

    [[nodiscard]] bool isLive() const { return !write; }
};

/// What came of setting a parameter.
struct SetAnswer
{
    enum class Outcome { Done, Unknown, ReadOnly, NotANumber, OutOfRange, Refused };
    Outcome outcome = Outcome::Done;
    std::string why;  ///< of Refused: the owner's sentence
};

/// All of them, by name: one truth for the console, the page of settings and tests. One thread: the ui's.
class Parameters
{
public:
    /// A name that is there already is replaced.
    void add(Parameter parameter);

    /// Null if there is none. Stays valid until the name is added again.
    [[nodiscard]] const Parameter* find(std::string_view name) const;
    /// Those whose name holds the text, in the order of names; empty: all.
    [[nodiscard]] std::vector<const Parameter*> matching(std::string_view text) const;
    /// Those whose name begins so.
    [[nodiscard]] std::vector<const Parameter*> beginningWith(std::string_view text) const;

    [[nodiscard]] SetAnswer set(std::string_view name, double value) const;
    /// To its initial value.
    [[nodiscard]] SetAnswer reset(std::string_view name) const;

private:
    std::vector<std::unique_ptr<const Parameter>> m_all;  ///< by name
};

}  // namespace core::settings
