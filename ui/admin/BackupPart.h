// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QDateTime>
#include <QList>
#include <QModelIndex>
#include <QString>
#include <QWidget>

#include "database/IntegrityIssue.h"
#include "ui/admin/AdminWords.h"

class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QStandardItemModel;

namespace ui::kit {
class ListTable;
class InlineConfirmation;
}  // namespace ui::kit

namespace ui::admin {

/// A backup that is there.
struct Backup
{
    QString file;
    QDateTime made;  ///< UTC
    qint64 bytes = 0;
    bool operator==(const Backup&) const = default;
};

/// Backups of the school's data: making one, trying that one can be brought back, bringing one back; and a thorough
/// look at everything. One of them at a time, with its progress.
class BackupPart final : public QWidget
{
    Q_OBJECT
public:
    explicit BackupPart(QWidget* parent);

    /// @param where    the database, to read
    /// @param isServer  whose administrator makes the backups
    void setDatabase(const QString& where, bool isServer);
    void setBackups(const QList<Backup>& backups);
    void showProgress(const QString& what);
    /// It has come to its end.
    /// @param sentence  what is said of it, in the language there is
    /// @param findings  what a check found
    /// @param isFault  it is not as it should be
    void finish(std::function<QString()> sentence, std::vector<database::IntegrityIssue> findings = {},
                bool isFault = false);
    /// What findings call people and classes by.
    void setNames(const NamesByUid& names);
    void setLessonTitles(const text::LessonTitles& titles);
    /// What was typed is no audit code; nothing has begun.
    void refuseCode();

signals:
    void backUpRequested();
    /// @param code  the audit code of a report, as it was typed; empty: there is none to compare with
    void checkRequested(const QString& code);
    /// The backup is to be put in the place of the database, and everybody here is logged out.
    void restoreRequested(const QString& file);
    void stopRequested();

private:
    void arrange();
    void connectButtons();
    void retranslateUi();
    void tell();
    void tellEnd();
    void fill();
    void restore();
    [[nodiscard]] QModelIndex chosenRow() const;
    /// Its file; empty: none is chosen.
    [[nodiscard]] QString chosen() const;

    QString m_where;
    bool m_isServer = false;
    bool m_isBusy = false;
    QWidget* m_begunBy = nullptr;           ///< had the focus when the work began, which disables it
    QWidget* m_focusedMeanwhile = nullptr;  ///< by Qt, unless the person has gone elsewhere
    kit::InlineConfirmation* m_thought;     ///< whether to restore
    QList<Backup> m_backups;
    QLabel* m_words;
    QPushButton* m_backUp;
    QPushButton* m_check;
    QLabel* m_codeCaption;
    QLineEdit* m_code;  ///< of a report
    QLabel* m_codeFault;
    QPushButton* m_restore;
    QPushButton* m_keep;  ///< beside it, while it asks whether one is sure
    QPushButton* m_stop;
    QProgressBar* m_bar;
    QLabel* m_said;
    std::function<QString()> m_sentence;  ///< how the last work ended
    bool m_isFault = false;
    std::vector<database::IntegrityIssue> m_found;
    NamesByUid m_names;
    text::LessonTitles m_titles;
    QPlainTextEdit* m_findings;
    QStandardItemModel* m_rows;
    kit::ListTable* m_table;
};

}  // namespace ui::admin
