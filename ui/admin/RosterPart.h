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

/// Imports a class list from a file. First shows line by line what the import would change; then imports it. The
/// one-time codes of new people can be saved afterwards.
class RosterPart final : public QWidget
{
    Q_OBJECT
public:
    explicit RosterPart(QWidget* parent);

    /// Shows the people and classes of a list, or its faults.
    /// @param isDone  true after the import; false if the list was only checked
    void showOutcome(const database::RosterOutcome& outcome, const QString& file, bool isDone);
    /// Shows the progress.
    void say(const QString& sentence);
    /// Shows why the checked list could not be imported.
    void refuse(const QString& sentence);
    /// Shows why a file is not a class list or cannot be read. Clears the previous list.
    void refuseFile(const QString& file, const QString& sentence, const QString& technical);
    /// Returns a description of the unsaved one-time codes. Empty if there are none.
    [[nodiscard]] QString unsavedChanges() const;
    void discardChanges() { showOutcome({}, {}, false); }

signals:
    void fileChosen(const QString& path);
    /// Emitted when the user requests the import of the checked list.
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
    bool m_isSaved = false;  ///< the codes have been saved
    QString m_what;          ///< the last error, or the saved files
    bool m_isWrong = false;  ///< m_what is an error
    QLabel* m_words;
    QPushButton* m_choose;
    QPushButton* m_enter;
    QPushButton* m_save;
    QLabel* m_said;
    QLabel* m_fault;
    QLabel* m_example;  ///< an example of such a file
    QStandardItemModel* m_rows;
    kit::ListTable* m_table;
};

}  // namespace ui::admin
