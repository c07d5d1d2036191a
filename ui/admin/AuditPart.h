// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>
#include <QWidget>

#include "database/AttemptRecord.h"
#include "ui/admin/AdminWords.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QStandardItemModel;

namespace ui::kit {
class ListTable;
class WordFilter;
}  // namespace ui::kit

namespace ui::admin {

/// The audit log, newest first: each action with its time and user. Also shows the audit code of the newest row, which
/// is printed on every report.
class AuditPart final : public QWidget
{
    Q_OBJECT
public:
    explicit AuditPart(QWidget* parent);

    void setNames(const NamesByUid& names);
    void setLessonTitles(const text::LessonTitles& titles);
    /// Returns whether the next request must leave out attempts. The rows on display may still contain them.
    [[nodiscard]] bool leavesOutAttempts() const;
    /// Replaces the rows.
    /// @param hasOlder  there are older rows than these
    void setRows(const QList<database::AuditRow>& newestFirst, const QString& code, bool hasOlder);
    /// Ends a failed request. The rows stay, and the filter for attempts is reset to theirs.
    void keepRows();
    /// Appends older rows below the row `beforeSeq`. Does nothing if that is no longer the last row.
    void addRows(qint64 beforeSeq, const QList<database::AuditRow>& newestFirst, bool hasOlder);

signals:
    /// Emitted when the newest rows are needed, with or without attempts; see leavesOutAttempts().
    void newestRequested();
    /// Emitted when the rows before this one are needed.
    void olderRequested(qint64 beforeSeq);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void retranslateUi();
    void fill();
    void fit();
    void tell();
    [[nodiscard]] QString countWords() const;

    QList<database::AuditRow> m_audit;
    NamesByUid m_names;
    text::LessonTitles m_titles;
    QLabel* m_code;
    QPushButton* m_copy;
    QLineEdit* m_search;
    QCheckBox* m_noAttempts;
    QLabel* m_count;
    QPushButton* m_older;
    QStandardItemModel* m_rows;
    kit::WordFilter* m_shown;
    kit::ListTable* m_table;
    QString m_head;
    bool m_hasOlder = false;
    bool m_isAsked = true;             ///< the newest rows were requested
    bool m_isWithoutAttempts = false;  ///< the rows that are shown
};

}  // namespace ui::admin
