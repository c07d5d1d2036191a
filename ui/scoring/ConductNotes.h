// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "core/grading/Process.h"
#include "core/grading/RuleChecker.h"

class QHBoxLayout;
class QLabel;

namespace ui::scoring {

/// Lists how a score was achieved, apart from its points: rule violations, each with a link to its moment, and one
/// sentence on time, force, aids and undone steps.
class ConductNotes final : public QWidget
{
    Q_OBJECT
public:
    explicit ConductNotes(QWidget* parent);

    /// @param aids  bits of core::servo::Aid that were in use
    void setConduct(const core::grading::Process& process, const std::vector<core::grading::Infraction>& infractions,
                    std::uint8_t aids);

    /// Returns a text such as "2 breaches of the rules".
    [[nodiscard]] static QString countWords(const std::vector<core::grading::Infraction>& infractions);
    /// Returns a text such as "The pulp is exposed at 0:37".
    [[nodiscard]] static QString breachWords(const core::grading::Infraction& infraction);

signals:
    /// Emitted when the user asks to replay the attempt from this moment, in seconds.
    void momentRequested(double seconds);

protected:
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] static QString factsOf(const core::grading::Process& process, std::uint8_t aids);
    void retranslateUi();
    void fillBreaches();

    std::optional<core::grading::Process> m_process;  ///< the shown process
    std::vector<core::grading::Infraction> m_infractions;
    std::uint8_t m_aids = 0;
    bool m_showsAll = false;  ///< whether all rule violations are shown

    QHBoxLayout* m_head = nullptr;
    QLabel* m_title = nullptr;
    QWidget* m_breaches = nullptr;
    QLabel* m_facts = nullptr;
};

}  // namespace ui::scoring
