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

/// What happened on the way to a score, whatever it cost: the breaches, each leading to its moment, and time, force,
/// aids and steps taken back in a sentence.
class ConductNotes final : public QWidget
{
    Q_OBJECT
public:
    explicit ConductNotes(QWidget* parent);

    /// @param aids  bits of core::servo::Aid that were in use
    void setConduct(const core::grading::Process& process, const std::vector<core::grading::Infraction>& infractions,
                    std::uint8_t aids);

    /// "2 breaches of the rules".
    [[nodiscard]] static QString countWords(const std::vector<core::grading::Infraction>& infractions);
    /// "The pulp is exposed at 0:37".
    [[nodiscard]] static QString breachWords(const core::grading::Infraction& infraction);

signals:
    /// The attempt is to be seen from this moment on.
    void momentRequested(double seconds);

protected:
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] static QString factsOf(const core::grading::Process& process, std::uint8_t aids);
    void retranslateUi();
    void fillBreaches();

    std::optional<core::grading::Process> m_process;  ///< that is told
    std::vector<core::grading::Infraction> m_infractions;
    std::uint8_t m_aids = 0;
    bool m_showsAll = false;  ///< breaches

    QHBoxLayout* m_head = nullptr;
    QLabel* m_title = nullptr;
    QWidget* m_breaches = nullptr;
    QLabel* m_facts = nullptr;
};

}  // namespace ui::scoring
