// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>
#include <QWidget>

#include "database/records.h"
#include "ui/admin/AdminWords.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QStandardItemModel;

namespace ui::people {
class ListTable;
class WordFilter;
}  // namespace ui::people

namespace ui::admin {

/// What was done here, when and by whom, newest first; and the code of the newest row, which stands on every report.
class AuditPart final : public QWidget
{
    Q_OBJECT
public:
    explicit AuditPart(QWidget* parent);

    void setNames(const NamesByUid& names);
    void setLessonTitles(const people::LessonTitles& titles);
    /// In place of what is there.
    void setRows(const QList<database::AuditRow>& newestFirst, const QString& code);
    /// Older ones, beneath.
    void addRows(const QList<database::AuditRow>& newestFirst);

signals:
    /// Rows before this one are wanted.
    void olderWanted(qint64 beforeSeq);

private:
    void speak();
    void fill();
    void tell();

    QList<database::AuditRow> m_audit;
    NamesByUid m_names;
    people::LessonTitles m_titles;
    QLabel* m_code;
    QPushButton* m_copy;
    QLineEdit* m_search;
    QLabel* m_count;
    QPushButton* m_older;
    QStandardItemModel* m_rows;
    people::WordFilter* m_shown;
    people::ListTable* m_table;
    QString m_head;
};

}  // namespace ui::admin
