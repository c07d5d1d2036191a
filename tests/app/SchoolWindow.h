// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>

#include "app/Application.h"
#include "lessons/LessonCatalog.h"
#include "ui/admin/AdminPage.h"
#include "ui/people/LoginPage.h"
#include "ui/shell/Actions.h"
#include "ui/shell/MessageBar.h"
#include "ui/shell/TabularLabel.h"

namespace support {

constexpr int kPatienceMs = 30000;
inline const std::string kPassword = "correct horse";

/// A lesson of the teacher's that is an exam, while this lives.
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
    ~Exam() { QFile::remove(m_file); }
    Exam(const Exam&) = delete;
    Exam& operator=(const Exam&) = delete;
    [[nodiscard]] const QString& file() const { return m_file; }

private:
    QString m_file = QDir(lessons::teachersFolder()).filePath("exam-36.lesson.json");
};

/// A school as another station has it open.
struct OtherStation
{
    /// @param place  a file with its key beside it, or the address of a server
    explicit OtherStation(const QString& place);
    [[nodiscard]] database::Session logIn(const std::string& name) const;

    std::unique_ptr<database::sql::Database> database;
    database::sql::School school;
};

/// The whole program with a school of its own, and what is done in it: what the tests of a school are made of.
class SchoolWindow : public QObject
{
protected:
    /// A school with an admin, a teacher, two students, and a class of the teacher and Sam.
    /// @param server  the address of its empty database; empty: it is a file
    void makeSchool(const QString& server = {});
    template <class T>
    T* child(const char* name = "") const
    {
        return m_application->window().findChild<T*>(QString::fromLatin1(name));
    }
    [[nodiscard]] ui::shell::Actions& actions() const { return *child<ui::shell::Actions>(); }
    [[nodiscard]] QString message() const { return child<ui::shell::MessageBar>()->sentence(); }
    [[nodiscard]] QString removed() const { return child<ui::shell::TabularLabel>("enamelRemoved")->text(); }
    [[nodiscard]] QString saidAtDoor() const
    {
        QStringList words;
        for (const QLabel* label : child<ui::people::LoginPage>()->findChildren<QLabel*>())
            words << label->text();
        return words.join('\n');
    }
    [[nodiscard]] ui::people::Door door() const { return child<ui::people::LoginPage>()->door(); }
    [[nodiscard]] QString file() const { return m_folder->filePath("school.sqlite"); }
    [[nodiscard]] QString place() const { return m_server.isEmpty() ? file() : m_server; }
    /// The program as a student starts it: at the door.
    void start(bool showsRound = false, const database::sql::Database::Options& opening = {});
    void click(const char* button) const { QTest::mouseClick(child<QPushButton>(button), Qt::LeftButton); }
    void logIn(const QString& name) const;
    /// From wherever he is.
    void leaveFor(const QString& name) const;
    void toTheTooth() const;
    void openSchool(ui::admin::AdminPage::Part part) const;
    /// Puts the bur onto the tooth and leaves it there. Returns where the pointer is, for who lets it go.
    QPoint press(double xMm) const;
    /// Cuts until something has come away.
    void drill(double xMm) const;
    void beginLesson(const std::string& id) const;
    /// So many attempts, to Sam's class.
    void give(const std::string& lesson, int attempts) const;
    /// Has a lesson's work graded, and expects a little of it.
    void gradeLesson() const;
    /// Has the work graded and waits until `keeping` is said of it; empty: until nothing is.
    void grade(const QString& said) const;
    [[nodiscard]] QString keeping() const
    {
        const auto* label = child<QLabel>("historyRemark");
        return label->isVisible() ? label->text() : QString();
    }
    /// What the database holds, asked beside the program.
    [[nodiscard]] int attemptsKept() const { return count("attempts"); }
    [[nodiscard]] int count(const char* rows) const;
    /// Opens the newest attempt of the history page.
    void openNewest() const;
    /// Saves the card that is shown as a PDF, and waits until that is said.
    void saveCard(const QString& path) const;

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_server;
    std::unique_ptr<app::Application> m_application;
};

}  // namespace support
