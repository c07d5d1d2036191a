// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QWidget>

class QCheckBox;
class QDateEdit;
class QLabel;
class QSpinBox;

namespace ui::people {

/// Inputs for the due date of an assignment (a day in local time, or none) and for its attempts.
class AssignTerms final : public QWidget
{
    Q_OBJECT
public:
    explicit AssignTerms(QWidget* parent);

    struct Terms
    {
        std::string dueUtc;    ///< the end of that day in local time; empty: no due date
        int attemptLimit = 0;  ///< 0: no limit
        bool operator==(const Terms&) const = default;
    };
    /// Sets the terms of the selected assignments.
    /// @param terms    those of the first
    /// @param lessons  number of selected assignments
    void setTerms(const Terms& terms, int lessons = 1);
    /// Resets to the defaults: due in a week, no limit.
    void reset();
    [[nodiscard]] Terms terms() const;
    /// Returns the terms with the user's changes since setTerms() applied.
    [[nodiscard]] Terms changed(const Terms& before) const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void retell();
    void updateNote();
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
