// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QString>
#include <QWidget>

#include "database/Person.h"

class QLabel;
class QPushButton;
class QStandardItemModel;

namespace ui::kit {
class ListTable;
}

namespace ui::admin {

/// A class list from a file: first what it would do, line by line, then it is entered, and the one-time codes of who is
/// new can be saved.
class RosterPart final : public QWidget
{
    Q_OBJECT
public:
    explicit RosterPart(QWidget* parent);

    /// @param isDone  entered; else only looked at
    void showOutcome(const database::RosterOutcome& outcome, const QString& file, bool isDone);
    /// What goes on.
    void say(const QString& sentence);
    /// Why what was looked at could not be entered just now.
    void refuse(const QString& sentence);
    /// A file is no class list, or cannot be read; what was known of the one before is forgotten.
    void refuseFile(const QString& file, const QString& sentence, const QString& technical);
    /// Describes one-time codes that are not saved. Empty: there are none.
    [[nodiscard]] QString unsavedChanges() const;
    void discardChanges() { showOutcome({}, {}, false); }

signals:
    void fileChosen(const QString& path);
    /// What was looked at is to be entered.
    void enterRequested();

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void retranslateUi();
    void tell();
    [[nodiscard]] QString outcomeWords() const;
    void fill();
    [[nodiscard]] int newcomers() const;
    void leaveCodes(const std::function<void()>& what);
    void chooseFile();
    void saveCodes();
    void writeCodes(const QString& path);

    database::RosterOutcome m_outcome;
    QString m_file;
    bool m_isEntering = false;
    bool m_isDone = false;
    bool m_isSaved = false;  ///< the codes are
    QString m_what;          ///< of the last failure, or what was saved
    bool m_isWrong = false;  ///< a failure
    QLabel* m_words;
    QPushButton* m_choose;
    QPushButton* m_enter;
    QPushButton* m_save;
    QLabel* m_said;
    QLabel* m_fault;
    QLabel* m_example;  ///< of what such a file looks like
    QStandardItemModel* m_rows;
    kit::ListTable* m_table;
};

}  // namespace ui::admin
