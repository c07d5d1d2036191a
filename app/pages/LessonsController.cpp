// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/LessonsController.h"

#include <memory>

#include <QDateTime>
#include <QDesktopServices>
#include <QDir>
#include <QTimer>
#include <QUrl>

#include "app/school/SchoolAccess.h"
#include "app/threads/Background.h"
#include "lessons/LessonCatalog.h"
#include "lessons/LessonPack.h"
#include "lessons/LessonReader.h"
#include "lessons/LessonVersion.h"
#include "lessons/ScoreSheetJson.h"
#include "ui/text/LessonTexts.h"
#include "ui/text/ValidationTexts.h"

namespace app {
namespace {

constexpr int kMostKnownAttempts = 200;
constexpr int kSchoolPatienceMs = 1500;  ///< after it the lessons are shown without an answer of the database

}  // namespace

using ui::text::FailedOperation;
using ui::window::MainWindow;

LessonsController::LessonsController(MainWindow& window, const SchoolSession& school)
    : m_window(window), m_school(school)
{
    connect(&window, &MainWindow::lessonsRequested, this, &LessonsController::showLessons);
    connect(&window.lessonEditing(), &ui::window::LessonEditing::knownAttemptsRequested, this,
            &LessonsController::showKnownAttempts);
    connect(&window.lessonEditing(), &ui::window::LessonEditing::unpackRequested, this, &LessonsController::unpack);
    connect(&window.lessonsPage(), &ui::catalog::LessonsPage::folderRequested, this, &LessonsController::openFolder);
}

bool LessonsController::isUsedUp(const std::string& lessonId) const
{
    const auto given = m_fromSchool.given.find(lessonId);
    return given != m_fromSchool.given.end() && given->second.attemptsLeft == 0;
}

void LessonsController::openFolder()
{
    const QString folder = lessons::teachersFolder();
    QDir().mkpath(folder);
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(folder)))
        m_window.showMessage(tr("No program answers here that shows folders. Your own lessons are in %1.")
                                 .arg(QDir::toNativeSeparators(folder)));
}

LessonsController::FromSchool LessonsController::shownOf(const database::LessonsOfUser& lessons)
{
    FromSchool found;
    for (const database::LessonStanding& one : lessons.standings)
        found.standings[one.lessonId] = {one.attempts, one.bestTenths, one.passed, QString::fromStdString(one.lastUtc)};
    for (const database::AssignedLesson& one : lessons.assigned) {
        ui::catalog::Given& here = found.given[one.lessonId];
        here.attemptsLeft = one.attemptsLeft;
        found.versions[one.lessonId] = one.lessonHash;
        for (const auto& [name, dueUtc] : one.classes) {
            const QString className = QString::fromStdString(name);
            const QDateTime due = QDateTime::fromString(QString::fromStdString(dueUtc), Qt::ISODate);
            if (!className.isEmpty()) {
                here.className += (here.className.isEmpty() ? QString() : QStringLiteral(", ")) + className;
                here.classes.emplace_back(className, due);
            }
            if (due.isValid() && (!here.due.isValid() || due < here.due))
                here.due = due;
        }
    }
    found.feedback = lessons.feedback;
    return found;
}

/// Reads the folder of lessons each time: a teacher may have changed it.
void LessonsController::showLessons()
{
    if (!m_school.isLoggedIn()) {
        fill(false);
        return;
    }
    // Lessons are files: they do not wait for a server that does not answer.
    const auto isAnswered = std::make_shared<bool>(false);
    QTimer::singleShot(kSchoolPatienceMs, this, [this, isAnswered] {
        if (!*isAnswered)
            fill(false);
    });
    m_school.service->ask(
        this, [who = m_school.user](const database::Repositories& school) { return school.lessons.ofUser(who); },
        [this, isAnswered, who = m_school.user](const core::Result<database::LessonsOfUser>& found) {
            *isAnswered = true;
            if (m_school.user != who)
                return;
            if (found)
                m_fromSchool = shownOf(*found);
            else  // an old answer is better than to show every lesson as not tried
                m_window.showError(found.error(), FailedOperation::ReadingSchool);
            fill(found.has_value());
        });
}

/// Shows the lessons of the folders, and those that are assigned in another version as the school stores them.
/// @param mayFetch  fetch the assigned versions that are not on this computer
void LessonsController::fill(bool mayFetch)
{
    struct Filled
    {
        std::vector<lessons::CatalogEntry> entries;
        std::vector<std::string> missing;  ///< versions
    };
    inBackground(
        this,
        [versions = m_fromSchool.versions] {
            Filled filled{lessons::readCatalog(lessons::teachersFolder()), {}};
            filled.missing = lessons::useVersions(filled.entries, versions);
            return filled;
        },
        [this, mayFetch, who = m_school.user](Filled& filled) {
            if (m_school.user != who)
                return;
            if (mayFetch && !filled.missing.empty()) {
                fetch(filled.missing);
                return;
            }
            m_window.lessonsPage().setLessons(std::move(filled.entries), m_fromSchool.standings, m_fromSchool.given);
            m_window.lessonsPage().setFeedback(m_fromSchool.feedback);
            emit shown();
        });
}

/// Brings assigned versions to this computer, and shows the lessons in any case.
void LessonsController::fetch(const std::vector<std::string>& versions)
{
    m_school.service->ask(
        this,
        [who = m_school.user, versions](const database::Repositories& school) -> core::Status {
            core::Status done;  // one version that cannot be brought does not hold up the others
            for (const std::string& hash : versions) {
                const auto pack = school.lessons.version(who, hash);
                const core::Status kept =
                    pack ? lessons::cacheVersion(hash, *pack) : core::Status(tl::unexpected(pack.error()));
                if (!kept)
                    done = kept;
            }
            return done;
        },
        [this, who = m_school.user](const core::Status& done) {
            if (m_school.user != who)
                return;
            if (!done)
                m_window.showError(done.error(), FailedOperation::ReadingSchool);
            fill(false);
        });
}

/// Unpacks into the folder of the user's own lessons, where a lesson can be changed.
void LessonsController::unpack(const QString& pack, const QString& name)
{
    inBackground(
        this,
        [pack, name]() -> core::Result<lessons::ReadLesson> {
            const QString folder = lessons::teachersFolder();
            const auto files = lessons::readPack(pack);
            if (!files)
                return tl::unexpected(files.error());
            if (auto put = lessons::putInto(folder, *files); !put)
                return tl::unexpected(put.error());
            return lessons::readLesson(QDir(folder).filePath(name));
        },
        [this](const core::Result<lessons::ReadLesson>& unpacked) {
            if (unpacked && unpacked->lesson) {
                m_window.lessonEditing().edit(*unpacked);
                return;
            }
            m_window.showMessage(
                tr("The pack was not unpacked, so its lesson cannot be changed. %1")
                    .arg(unpacked ? QString() : ui::text::faultWords(core::wordsOf(unpacked.error()))));
        });
}

/// Gives the editor the measures of graded attempts at exactly this version of a lesson: the user's own and, for a
/// teacher, those of their classes.
void LessonsController::showKnownAttempts(const lessons::Lesson& lesson)
{
    m_window.lessonEditing().setKnownAttempts({});
    if (!m_school.isLoggedIn())
        return;
    m_school.service->ask(
        this,
        [who = m_school.user, id = lesson.id, hash = lesson.hash](const database::Repositories& school) {
            return school.lessons.sheets(who, id, hash, kMostKnownAttempts);
        },
        [this](const core::Result<std::vector<database::KeptSheet>>& sheets) {
            std::vector<ui::lessoneditor::MeasuredAttempt> known;
            for (const database::KeptSheet& sheet : sheets.value_or(std::vector<database::KeptSheet>{}))
                known.push_back({QString::fromStdString(sheet.finishedUtc), lessons::measuredIn(sheet.json)});
            m_window.lessonEditing().setKnownAttempts(std::move(known));
        });
}

}  // namespace app
