// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QTableView>

#include "database/Doubt.h"
#include "database/sql/DatabaseContext.h"
#include "database/sql/Statement.h"
#include "lessons/LessonCatalog.h"
#include "tests/app/ProgramWindow.h"
#include "ui/admin/AdminPage.h"
#include "ui/people/LoginPage.h"

namespace support {

inline const std::string kPassword = "correct horse";

/// An exam in the teacher's folder. The destructor removes its file.
class Exam
{
public:
    Exam()
    {
        QDir().mkpath(QFileInfo(m_file).absolutePath());
        QFile lesson(m_file);
        if (!lesson.open(QIODevice::WriteOnly))
            qFatal("the exam cannot be written");
        lesson.write(R"({"format": 1, "based_on": "decay-36-1-small.lesson.json", "id": "exam-36", "exam": true,
                         "title": {"en": "The exam"}})");
    }
    ~Exam() { remove(); }
    /// Changes the lesson, as a student could.
    /// @param keys  JSON, added to those of the lesson
    void change(const QByteArray& keys) const
    {
        QFile lesson(m_file);
        if (!lesson.open(QIODevice::ReadWrite))
            qFatal("the exam cannot be changed");
        const QByteArray changed = lesson.readAll().replace("\"exam\": true", "\"exam\": true, " + keys);
        lesson.resize(0);
        lesson.seek(0);
        lesson.write(changed);
    }
    void remove() const { QFile::remove(m_file); }
    Exam(const Exam&) = delete;
    Exam& operator=(const Exam&) = delete;

private:
    QString m_file = QDir(lessons::teachersFolder()).filePath("exam-36.lesson.json");
};

/// A connection of another station to the same school.
struct OtherStation
{
    /// @param place  a database file with its key next to it, or the address of a server
    explicit OtherStation(const QString& place);
    [[nodiscard]] database::Login logIn(const std::string& name) const;
    [[nodiscard]] QVariant ask(const QString& query) const
    {
        return database::sql::ask(school.db, query, "read").value();
    }
    [[nodiscard]] qint64 idOf(const QString& name) const
    {
        return ask("SELECT id FROM people WHERE username = '" + name + "'").toLongLong();
    }
    void execute(const QString& statement) const { QVERIFY(database::sql::execute(school.db, statement, "write")); }

    std::unique_ptr<database::sql::Database> database;
    database::sql::DatabaseContext school;
};

/// The whole program with a school of its own.
class SchoolWindow : public ProgramWindow
{
protected:
    /// Makes a school with an admin, the teacher Ines, the students Sam and Sue, and a class of Ines and Sam.
    void makeSchool(const QString& server = {});
    /// Makes an empty folder and copies the database file of the school into it.
    void takeCopyOfSchool();
    [[nodiscard]] ui::people::LoginMode door() const { return child<ui::people::LoginPage>()->door(); }
    [[nodiscard]] bool isAtDoor() const { return window().navigation().isAtLogin(); }
    [[nodiscard]] QString saidAtDoor() const;
    void waitForDoorToSay(const QString& words) const;
    [[nodiscard]] QString file() const { return m_folder->filePath("school.sqlite"); }
    [[nodiscard]] QString place() const { return m_server.isEmpty() ? file() : m_server; }
    /// Moves the database file of the school and the files that belong to it away.
    void moveAway() const;
    /// Overwrites the database file of the school with noise.
    void damageSchool() const;
    /// Starts the program with the school. It shows the login page.
    void start(app::WindowOptions options = {});
    void startAs(const QString& name)
    {
        start();
        logIn(name);
    }
    /// Fills in the login page and clicks its button.
    void typeLogin(const QString& name, const QString& password = QString::fromStdString(kPassword)) const;
    /// Enters a password to unlock the window, and waits for the answer.
    void tryPassword(const QString& password = QString::fromStdString(kPassword)) const;
    void logIn(const QString& name) const;
    /// Logs out from any page.
    void logOut() const;
    void switchTo(const QString& name) const;
    void beGuest() const;
    /// Goes to the practice room and waits for the tooth.
    void goToTooth() const;
    void openAdminPage(ui::admin::AdminPage::Part part) const;
    /// Assigns a lesson to Sam's class, with this number of attempts.
    void assign(const std::string& lesson, int attempts, const std::string& dueUtc = {}) const;
    /// Marks all attempts in the database again, and expects the scores that were reported.
    /// @param doubt  with which they are stored
    void expectProven(database::Doubt doubt = database::Doubt::None) const;
    /// Requests the grade, and waits until the score page shows these words about where the grade is saved.
    void grade(const QString& saved) const;
    /// Grades a lesson, and waits until the database has this number of attempts.
    void gradeLesson(int attempts) const;
    /// Returns the text of the score page about where the grade is saved.
    [[nodiscard]] QString saved() const;
    void waitForSaved(const QString& words) const;
    /// Opens the list of the user's own attempts after all earlier requests to the database have been answered.
    void openAttempts() const;
    /// Returns the number of rows in the database, read by another connection; -1 if it cannot be read.
    [[nodiscard]] int count(const QString& rows) const;
    [[nodiscard]] int attempts() const { return count("attempts"); }
    /// Opens the page that lists the attempts of the first student of the class.
    void openStudent() const;
    /// Opens the newest of the listed attempts.
    void openNewest() const;
    [[nodiscard]] int studentsShown() const { return child<QTableView>("matrix")->model()->rowCount(); }
    /// Saves the score card as a PDF, and waits for the confirmation.
    void savePdf(const QString& path) const;
    /// Returns the uid of a user. The user's journals are in a folder of that name.
    [[nodiscard]] QString uidOf(const QString& name) const;
    [[nodiscard]] bool isUnfinishedOffered() const;

    QString m_server;

private:
    std::unique_ptr<QTemporaryDir> m_original;
};

}  // namespace support
