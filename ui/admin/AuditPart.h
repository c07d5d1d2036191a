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

/// What was done here, when and by whom, newest first; and the code of the newest row, which stands on every report.
class AuditPart final : public QWidget
{
    Q_OBJECT
public:
    explicit AuditPart(QWidget* parent);

    void setNames(const NamesByUid& names);
    void setLessonTitles(const text::LessonTitles& titles);
    /// Rows that tell of attempts are to be left out: of those that are asked for, not of those that are there.
    [[nodiscard]] bool leavesOutAttempts() const;
    /// In place of what is there.
    /// @param hasOlder  there are more before them
    void setRows(const QList<database::AuditRow>& newestFirst, const QString& code, bool hasOlder);
    /// What was asked for cannot be read: what is there stays, as it was chosen.
    void keepRows();
    /// Older ones, beneath the row `beforeSeq`; nothing where that is the last no longer.
    void addRows(qint64 beforeSeq, const QList<database::AuditRow>& newestFirst, bool hasOlder);

signals:
    /// The newest are wanted: with attempts, or without.
    void newestRequested();
    /// Rows before this one are wanted.
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
    bool m_isAsked = true;             ///< the newest are on their way
    bool m_isWithoutAttempts = false;  ///< those that are there
};

}  // namespace ui::admin
