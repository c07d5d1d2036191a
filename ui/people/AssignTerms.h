// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QWidget>

class QCheckBox;
class QDateEdit;
class QLabel;
class QSpinBox;

namespace ui::people {

/// When a lesson is due, a day of this computer's calendar or none, and how often it may be tried.
class AssignTerms final : public QWidget
{
    Q_OBJECT
public:
    explicit AssignTerms(QWidget* parent);

    struct Terms
    {
        std::string dueUtc;    ///< the end of the day here; empty: none
        int attemptLimit = 0;  ///< 0: as many as one likes
        bool operator==(const Terms&) const = default;
    };
    /// @param lessons  how many have terms of which these are the first
    void setTerms(const Terms& terms, int lessons = 1);
    /// As to begin with: due in a week, with as many attempts as one likes.
    void reset();
    [[nodiscard]] Terms terms() const;
    /// What somebody has changed here since setTerms(), and the rest as it was before.
    [[nodiscard]] Terms changed(const Terms& before) const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void retell();
    void tellNote();
    void sayCalendar();

    QCheckBox* m_isDue;
    QDateEdit* m_day;
    QLabel* m_limitWord;
    QSpinBox* m_limit;
    QLabel* m_note;
    int m_lessons = 1;
    bool m_isDueChanged = false;
    bool m_isLimitChanged = false;
};

}  // namespace ui::people
