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

/// An existing backup.
struct Backup
{
    QString file;
    QDateTime made;  ///< UTC
    qint64 bytes = 0;
    bool operator==(const Backup&) const = default;
};

/// The backups of the school's database: creating a backup, verifying that it can be restored, and restoring it; and
/// the integrity check. One operation runs at a time, with its progress.
class BackupPart final : public QWidget
{
    Q_OBJECT
public:
    explicit BackupPart(QWidget* parent);

    /// @param where    the database, for display
    /// @param isServer  the database is on a server, whose administrator makes the backups
    void setDatabase(const QString& where, bool isServer);
    void setBackups(const QList<Backup>& backups);
    void showProgress(const QString& what);
    /// Ends the operation.
    /// @param sentence  returns the result in the current language
    /// @param findings  the issues that an integrity check found
    /// @param isFault  the operation failed, or found issues
    void finish(std::function<QString()> sentence, std::vector<database::IntegrityIssue> findings = {},
                bool isFault = false);
    /// Sets the names of people and classes in the issues.
    void setNames(const NamesByUid& names);
    void setLessonTitles(const text::LessonTitles& titles);
    /// Shows that the typed text is not an audit code. No operation has started.
    void refuseCode();

signals:
    void backUpRequested();
    /// Emitted when the user requests an integrity check.
    /// @param code  the audit code of a report, as typed; empty: no comparison
    void checkRequested(const QString& code);
    /// Emitted when the user requests to replace the database by a backup, which logs all users out.
    void restoreRequested(const QString& file);
    void stopRequested();

private:
    void arrange();
    void connectButtons();
    void retranslateUi();
    void tell();
    void showResult();
    void fill();
    void restore();
    [[nodiscard]] QModelIndex chosenRow() const;
    /// Returns the selected file; empty: none.
    [[nodiscard]] QString chosen() const;

    QString m_where;
    bool m_isServer = false;
    bool m_isBusy = false;
    QWidget* m_begunBy = nullptr;           ///< widget that had the focus when the operation began and disabled it
    QWidget* m_focusedMeanwhile = nullptr;  ///< widget that Qt gave the focus during the operation
    kit::InlineConfirmation* m_thought;     ///< the confirmation before restoring a backup
    QList<Backup> m_backups;
    QLabel* m_words;
    QPushButton* m_backUp;
    QPushButton* m_check;
    QLabel* m_codeCaption;
    QLineEdit* m_code;  ///< the audit code of a report
    QLabel* m_codeFault;
    QPushButton* m_restore;
    QPushButton* m_keep;  ///< cancels the restore while it is being confirmed
    QPushButton* m_stop;
    QProgressBar* m_bar;
    QLabel* m_said;
    std::function<QString()> m_sentence;  ///< the result of the last operation
    bool m_isFault = false;
    std::vector<database::IntegrityIssue> m_found;
    NamesByUid m_names;
    text::LessonTitles m_titles;
    QPlainTextEdit* m_findings;
    QStandardItemModel* m_rows;
    kit::ListTable* m_table;
};

}  // namespace ui::admin
