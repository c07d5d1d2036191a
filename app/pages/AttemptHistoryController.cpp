// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/AttemptHistoryController.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <memory>
#include <utility>

#include <QDir>
#include <QPagedPaintDevice>
#include <QPointer>

#include "app/threads/Background.h"
#include "database/sql/Attempts.h"
#include "database/sql/Audit.h"
#include "database/sql/Classes.h"
#include "database/sql/Export.h"
#include "database/sql/Feedback.h"
#include "database/sql/Overview.h"
#include "database/sql/StartedExams.h"
#include "lessons/Assignment.h"
#include "lessons/ScoreSheetJson.h"
#include "ui/admin/AdminPage.h"
#include "ui/people/ClassPage.h"
#include "ui/people/HistoryPage.h"
#include "ui/report/Printing.h"
#include "ui/scoring/CommentsPanel.h"
#include "ui/scoring/ScorePage.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/LessonTexts.h"

namespace app {
namespace {

constexpr std::size_t kMostBesides = 12;  ///< attempts to choose from

namespace text = ui::text;
using database::sql::DatabaseContext;
using ui::people::AssignPage;
using ui::people::ClassPage;
using ui::people::HistoryPage;
using ui::window::MainWindow;

std::map<std::string, QString> criteriaOf(const lessons::Rubric& rubric)
{
    std::map<std::string, QString> names;
    for (const lessons::CriterionRule& rule : rubric.criteria) {
        lessons::Criterion criterion;
        criterion.id = rule.id;
        criterion.title = rule.title;
        criterion.measure = rule.measure;
        names[rule.id] = text::criterionName(criterion);
    }
    return names;
}

/// Students with the same name have their login's behind it, so that nobody takes one for the other; who has none is
/// called by it.
database::ClassOverview toldApart(database::ClassOverview overview)
{
    std::map<std::string, int> bearers;
    for (const database::MatrixStudent& student : overview.students)
        ++bearers[student.fullName];
    for (database::MatrixStudent& student : overview.students)
        if (student.fullName.empty())
            student.fullName = student.username;
        else if (bearers[student.fullName] > 1)
            student.fullName += " (" + student.username + ")";
    return overview;
}

/// Who made an attempt, and when.
QString whose(const QString& person, const database::AttemptRecord& attempt)
{
    return QStringLiteral("%1, %2").arg(person, ui::text::when(attempt.finishedUtc));
}

/// What a class is to do, and how far it is.
struct ClassNow
{
    database::ClassOverview overview;
    std::vector<database::ClassAssignment> given;
};

/// Of one person.
struct AttemptsNow
{
    std::vector<database::AttemptRecord> attempts;
    std::vector<database::ExamStart> withoutScore;
    std::vector<database::Feedback> feedback;
};

core::Result<AttemptsNow> readAttempts(const DatabaseContext& school, const database::Login& who,
                                       database::PersonId person)
{
    auto attempts = database::sql::history(school, who, person, {});
    auto withoutScore = database::sql::examsWithoutScore(school, who, person);
    auto feedback = database::sql::feedbackFor(school, who, person);
    if (!attempts || !withoutScore)
        return tl::unexpected(attempts ? withoutScore.error() : attempts.error());
    if (!feedback)
        return tl::unexpected(feedback.error());
    return AttemptsNow{std::move(*attempts), std::move(*withoutScore), std::move(*feedback)};
}

/// Those that are pinned to a moment, in order of time.
std::vector<ui::replay::Remark> remarksOf(const database::AttemptTalk& talk)
{
    std::vector<ui::replay::Remark> remarks;
    for (const database::AttemptComment& comment : talk.comments) {
        if (!comment.momentMs)
            continue;
        std::optional<glm::dvec3> place;
        if (comment.placeMm)
            place = glm::dvec3(comment.placeMm->at(0), comment.placeMm->at(1), comment.placeMm->at(2));
        remarks.push_back({static_cast<double>(*comment.momentMs) / 1000.0, place, comment.author, comment.words});
    }
    std::stable_sort(remarks.begin(), remarks.end(), [](const auto& a, const auto& b) { return a.atS < b.atS; });
    return remarks;
}

/// As it was kept; where no sheet says how the points were lost, with what else is known of it.
/// @param rubric  of the lesson, as it is today; null: there is none
lessons::ScoreSheet sheetOf(const database::AttemptRecord& attempt, const lessons::Rubric* rubric)
{
    if (auto kept = lessons::sheetIn(attempt.scoreSheetJson); kept && kept->totalTenths == attempt.scoreTenths)
        return *kept;
    lessons::ScoreSheet sheet;
    sheet.rubricHash = attempt.rubricHash;
    sheet.passMarkTenths = attempt.passMarkTenths;
    sheet.totalTenths = attempt.scoreTenths;
    if (rubric != nullptr && rubric->hash == attempt.rubricHash) {
        sheet.rubricId = rubric->id;
        sheet.rubricVersion = rubric->version;
        sheet.rubricTitle = rubric->title;
    }
    for (const database::CriterionLoss& loss : attempt.criteria) {
        lessons::Criterion criterion;
        criterion.id = loss.id;
        criterion.title = {{"en", loss.id}};
        criterion.weightTenths = loss.weightTenths;
        criterion.lostTenths = loss.lostTenths;
        criterion.critical = loss.weightTenths == 0;
        criterion.share = loss.lostTenths > 0 ? 1.0 : 0.0;
        const auto isIt = [&](const lessons::CriterionRule& rule) { return rule.id == loss.id; };
        if (rubric != nullptr)
            if (const auto rule = std::find_if(rubric->criteria.begin(), rubric->criteria.end(), isIt);
                rule != rubric->criteria.end())
                criterion.title = rule->title.empty() ? lessons::LocalText{{"en", rule->measure}} : rule->title;
        sheet.criteria.push_back(std::move(criterion));
    }
    return sheet;
}

/// Why a recording is of no use; of anything else one can only be told.
bool isOfTheRecording(core::ErrorCode code)
{
    using core::ErrorCode;
    return code == ErrorCode::FileMissing || code == ErrorCode::FileUnreadable || code == ErrorCode::BadStructure;
}

void showAttempts(HistoryPage& page, const AttemptsNow& now)
{
    page.setExamsWithoutScore({now.withoutScore.begin(), now.withoutScore.end()});
    page.setHistory({now.attempts.begin(), now.attempts.end()});
    page.setFeedback(now.feedback);
}

core::Result<ClassNow> readClass(const DatabaseContext& school, const database::Login& who, database::ClassId ofClass)
{
    auto overview = database::sql::classOverview(school, who, ofClass);
    auto given = database::sql::listAssignments(school, who);
    if (!overview || !given)
        return tl::unexpected(overview ? given.error() : overview.error());
    return ClassNow{std::move(*overview), std::move(*given)};
}

}  // namespace

AttemptHistoryController::AttemptHistoryController(MainWindow& window, SchoolService& desk,
                                                   std::function<database::Login()> who)
    : m_window(window), m_desk(desk), m_who(std::move(who))
{
    HistoryPage& history = m_window.historyPage();
    text::bindTranslation(&history, [desk = QPointer<AttemptHistoryController>(this)] {
        if (desk)
            desk->tellLessons();
    });
    connect(&m_window, &MainWindow::attemptsRequested, this, [this] { openHistory(m_who().person(), {}, {}); });
    connect(&m_window, &MainWindow::feedbackRequested, this, [this, &history](qint64 attempt) {
        if (attempt == 0)
            openHistory(m_who().person(), {}, {});
        else {
            m_reads = database::AttemptId{attempt};
            emit history.attemptOpenRequested(attempt);
        }
    });
    connect(&history, &HistoryPage::lessonChosen, this, &AttemptHistoryController::tellClassAt);
    connect(&history, &HistoryPage::readAgainRequested, this, &AttemptHistoryController::tellAttempts);
    connect(&history, &HistoryPage::replayRequested, this, [this](qint64 id) {
        fetch(id, [this](const auto& attempt, const auto& recording) {
            emit replayRequested(recording, attempt, whose(makerOf(attempt), attempt));
        });
    });
    connect(&m_window, &MainWindow::besidesRequested, this, &AttemptHistoryController::offerBeside);
    connect(&history, &HistoryPage::attemptOpenRequested, this, [this](qint64 id) {
        fetch(
            id, [this](const auto& attempt, const auto& recording) { emit scoreRequested(attempt, recording); },
            [this](const auto& attempt) { openSheet(attempt); });
    });
    connectTalk();
    connectReport();
    ClassPage& classes = m_window.classPage();
    connect(&m_window.adminPage(), &ui::admin::AdminPage::partOpened, this, [this] {
        if (m_titles.isEmpty())
            readLessons([] {});
    });
    m_again.setSingleShot(true);
    m_again.setInterval(desk.retryMs());
    connect(&m_again, &QTimer::timeout, &classes, [&classes] {
        if (classes.isVisible() && !classes.isRead())  // elsewhere it is read when somebody comes back to it
            classes.readAgain();
    });
    connect(&classes, &ClassPage::listRequested, this, [this] {
        if (!m_who().isGuest())
            tellClasses();
    });
    connect(&m_window, &MainWindow::classesRequested, this, &AttemptHistoryController::openClasses);
    connect(&classes, &ClassPage::classChosen, this, [this](qint64 id) { tellOverview({id}); });
    connect(&classes, &ClassPage::lessonChosen, this, &AttemptHistoryController::tellResults);
    connect(&classes, &ClassPage::assignRequested, this, &AttemptHistoryController::openAssign);
    connect(&m_window.assignPage(), &AssignPage::changeRequested, this, &AttemptHistoryController::changeAssignments);
    const auto nameOf = [this](qint64 person) {
        for (const database::MatrixStudent& student : m_overview.students)
            if (student.id.value == person)
                return QString::fromStdString(student.fullName);
        return QString();
    };
    connect(&classes, &ClassPage::studentRequested, this,
            [this, nameOf](qint64 person) { openHistory({person}, nameOf(person), {}); });
    connect(&classes, &ClassPage::attemptsRequested, this, [this, nameOf](qint64 person, const QString& lesson) {
        openHistory({person}, nameOf(person), lesson.toStdString());
    });
}

void AttemptHistoryController::forget()
{
    talkAbout({});
    m_talkedName.clear();
    m_played.reset();
    m_asked = {};
    m_person = {};
    m_names.clear();
    m_overview = {};
    m_given.clear();
    m_results = {};
    m_reads = {};
}

/// Returns a check that the page has not changed since: an answer must not pull a person from another page.
std::function<bool()> AttemptHistoryController::isStillThere() const
{
    return [this, page = m_window.page()] { return m_window.page() == page; };
}

/// A teacher's folder may have changed since it was read last.
void AttemptHistoryController::readLessons(const std::function<void()>& then)
{
    inBackground(
        this, [] { return lessons::readCatalog(lessons::teachersFolder()); },
        [this, then, who = m_who()](std::vector<lessons::CatalogEntry>& entries) {
            if (m_who() != who)  // somebody else works here by now
                return;
            m_catalog = std::move(entries);
            std::stable_sort(m_catalog.begin(), m_catalog.end(), [](const auto& a, const auto& b) {
                const auto place = [](const lessons::CatalogEntry& entry) {
                    return entry.isFaulty() ? std::pair(INT_MAX, std::string())
                                            : ui::text::groupPlace(*entry.read.lesson);
                };
                return place(a) < place(b);
            });
            tellLessons();
            then();
        });
}

/// What lessons are called, in the language of today.
void AttemptHistoryController::tellLessons()
{
    std::vector<ui::people::LessonOffer> offers;
    std::map<std::string, ui::text::CriterionNames> criteria;
    if (const auto free = lessons::practiceRubric())
        criteria[{}] = criteriaOf(*free);
    m_titles.clear();
    for (const lessons::CatalogEntry& entry : m_catalog) {
        if (entry.isFaulty())
            continue;
        const lessons::Lesson& one = *entry.read.lesson;
        criteria[one.id] = criteriaOf(one.rubric);
        const QString title = ui::text::said(one.title);
        m_titles[QString::fromStdString(one.id)] = title;
        const QString file = entry.isShipped ? QString() : entry.pack.isEmpty() ? entry.read.file : entry.pack;
        offers.push_back({one.id, title, ui::text::toothWords(one), ui::text::groupName(one), file});
    }
    m_window.historyPage().setLessonTitles(m_titles);
    m_window.historyPage().setCriterionNames(criteria);
    m_window.classPage().setLessonTitles(m_titles);
    m_window.adminPage().setLessonTitles(m_titles);
    m_window.assignPage().setLessons(offers);
    if (const lessons::Lesson* shown = lesson(m_results.lessonId))
        m_window.classPage().setResults(m_results, shown->rubric.passMarkTenths, criteriaOf(shown->rubric));
}

/// Null: there is none any more.
const lessons::Lesson* AttemptHistoryController::lesson(const std::string& id) const
{
    for (const lessons::CatalogEntry& entry : m_catalog)
        if (!entry.isFaulty() && entry.read.lesson->id == id)
            return &*entry.read.lesson;
    return nullptr;
}

void AttemptHistoryController::connectTalk()
{
    ui::scoring::CommentsPanel& talk = m_window.scorePage().talk();
    connect(&talk, &ui::scoring::CommentsPanel::commentRequested, this,
            [this](const QString& words, std::optional<std::int64_t> momentMs,
                   const std::optional<std::array<double, 3>>& placeMm) {
                sayInTalk([comment = database::sql::NewComment{words.toStdString(), placeMm, momentMs}](
                              const DatabaseContext& school, const database::Login& who, database::AttemptId id) {
                    return database::sql::addComment(school, who, id, comment).map([](std::int64_t) {});
                });
            });
    connect(&talk, &ui::scoring::CommentsPanel::withdrawRequested, this, &AttemptHistoryController::takeBack);
    connect(&talk, &ui::scoring::CommentsPanel::overrideRequested, this,
            [this](std::optional<int> tenths, const QString& reason, std::size_t before) {
                sayInTalk([tenths, before, reason = reason.toStdString()](
                              const DatabaseContext& school, const database::Login& who, database::AttemptId id) {
                    return database::sql::overrideScore(school, who, id, tenths, reason, before);
                });
            });
    connect(&talk, &ui::scoring::CommentsPanel::momentRequested, &m_window, &MainWindow::momentRequested);
    connect(&m_window, &MainWindow::replayShown, this, [this, &talk](double seconds) {
        if (playsTalkedAbout())
            talk.setMoment(std::llround(1000.0 * seconds));
    });
}

/// Does it to the attempt that is talked about, and shows the talk anew; what is refused is said where it was typed.
template <class Work>
void AttemptHistoryController::sayInTalk(Work work)
{
    if (!m_talkedAbout)
        return;
    askAs(
        [who = m_who(), id = database::AttemptId{m_talkedAbout->id},
         work = std::move(work)](const DatabaseContext& school) -> core::Result<bool> {
            if (auto done = work(school, who, id); !done)
                return tl::unexpected(done.error());
            return true;
        },
        [this, attempt = m_talkedAbout->id, whose = whoseIsTalkedAbout()](const core::Result<bool>& done) {
            if (done)
                m_window.scorePage().talk().answer(attempt);
            if (done || done.error().code == core::ErrorCode::ChangedSince)
                tellTalk();
            if (!done) {
                const QString sentence = whyNotDone(done.error());
                m_window.scorePage().talk().answer(attempt, sentence);
                tellRefused(attempt, whose, sentence);
            }
        });
}

/// A teacher may comment on each of their students. So a refusal means that the student has left their classes.
QString AttemptHistoryController::whyNotDone(const core::Error& error) const
{
    if (!isOfAnotherNow(error))
        return text::errorText(error, text::FailedOperation::ChangingSchool);
    return tr("That was not done: this student is in none of your classes any more. What you have typed stays here; an "
              "admin can enter you into the class again.");
}

bool AttemptHistoryController::isOfAnotherNow(const core::Error& error) const
{
    return error.code == core::ErrorCode::NotAllowed && m_who().role() == database::Role::Instructor;
}

/// Shows a refusal on the page where the person now is, if they have left the attempt.
void AttemptHistoryController::tellRefused(qint64 attempt, const QString& whose, const QString& sentence)
{
    ui::scoring::ScorePage& page = m_window.scorePage();
    if (!page.isVisible() || page.talk().attempt() != attempt)
        //: %1: who made an attempt, and when; %2: why
        m_window.showWarning(tr("On the attempt of %1: %2").arg(whose, sentence));
}

/// Where that was done already, at another computer, it goes as well.
void AttemptHistoryController::takeBack(qint64 comment)
{
    if (!m_talkedAbout)
        return;
    askAs(
        [who = m_who(), comment](const DatabaseContext& school) -> core::Result<bool> {
            const auto done = database::sql::withdrawComment(school, who, comment);
            if (!done && done.error().code != core::ErrorCode::ChangedSince)
                return tl::unexpected(done.error());
            return done.has_value();
        },
        [this, comment, attempt = m_talkedAbout->id, whose = whoseIsTalkedAbout()](const core::Result<bool>& done) {
            if (!done) {
                const QString sentence = whyNotDone(done.error());
                m_window.scorePage().talk().keepComment(comment, attempt, sentence);
                tellRefused(attempt, whose, sentence);
                return;
            }
            m_window.scorePage().talk().withdraw(comment, !*done);
            tellTalk();
        });
}

void AttemptHistoryController::talkAbout(const std::optional<database::AttemptRecord>& attempt)
{
    m_talkedAbout = attempt;
    ui::scoring::ScorePage& page = m_window.scorePage();
    page.setTalkVisible(attempt.has_value());
    page.talk().setAttempt(attempt ? attempt->id : 0);
    if (!attempt)
        return;
    page.talk().setScore(attempt->scoreTenths, attempt->passMarkTenths, attempt->passed);
    m_talkedName = makerOf(*attempt);
    const bool teaches = m_who().role() == database::Role::Instructor && attempt->person != m_who().person();
    page.setMayTalk(teaches);
    page.talk().setTalk({});
    tellTalk();
    tellBefore();
}

/// Whoever's attempts are shown by now: who opens one has seen its maker's before.
QString AttemptHistoryController::makerOf(const database::AttemptRecord& attempt) const
{
    if (attempt.person == m_who().person())
        return QString::fromStdString(m_who().fullName());
    const auto known = m_names.find(attempt.person.value);
    return known != m_names.end() ? known->second : QString();
}

/// What a lesson is called is in its file.
void AttemptHistoryController::openSheet(const database::AttemptRecord& attempt)
{
    readLessons([this, attempt, isStillThere = isStillThere()] {
        if (!isStillThere()) {
            m_reads = {};
            return;
        }
        const lessons::Lesson* const known = lesson(attempt.lessonId);
        const auto practice = lessons::practiceRubric();
        const lessons::Rubric* const rubric = known != nullptr                       ? &known->rubric
                                              : attempt.lessonId.empty() && practice ? &*practice
                                                                                     : nullptr;
        emit sheetRequested(attempt, sheetOf(attempt, rubric),
                            [desk = QPointer<AttemptHistoryController>(this), attempt] {
                                return desk ? desk->workOf(attempt) : QString();
                            });
    });
}

QString AttemptHistoryController::workOf(const database::AttemptRecord& attempt) const
{
    if (const lessons::Lesson* known = lesson(attempt.lessonId))
        return ui::text::said(known->title);
    const QString title = ui::text::lessonTitle({}, attempt.lessonId);
    return attempt.lessonId.empty() ? QStringLiteral("%1, %2").arg(title, QString::fromStdString(attempt.tooth))
                                    : title;
}

QString AttemptHistoryController::whoseIsTalkedAbout() const
{
    return m_talkedAbout ? whose(m_talkedName, *m_talkedAbout) : QString();
}

/// The attempts before it, of the same lesson or without one of the same tooth. Until they are known nothing is said of
/// its being the first.
void AttemptHistoryController::tellBefore()
{
    m_window.scorePage().setKeeping(ui::scoring::ScorePage::Keeping::Pending);
    const database::AttemptRecord& opened = *m_talkedAbout;
    askAs([who = m_who(), person = opened.person,
           query = database::sql::HistoryQuery{opened.lessonId, opened.lessonId.empty() ? opened.tooth : ""}](
              const DatabaseContext& school) { return database::sql::history(school, who, person, query); },
          [this, id = opened.id](const core::Result<std::vector<database::AttemptRecord>>& found) {
              if (!m_talkedAbout || m_talkedAbout->id != id)
                  return;
              if (!found) {
                  refuse(found.error());
                  return;
              }
              const auto shown =
                  std::find_if(found->begin(), found->end(), [id](const auto& attempt) { return attempt.id == id; });
              if (shown == found->end())
                  return;
              m_window.scorePage().setHistory({shown, found->end()});
              m_window.scorePage().setKeeping(ui::scoring::ScorePage::Keeping::Kept);
          });
}

void AttemptHistoryController::tellTalk()
{
    if (!m_talkedAbout)  // another is shown by now
        return;
    askAs([who = m_who(), id = database::AttemptId{m_talkedAbout->id}](
              const DatabaseContext& school) { return database::sql::readTalk(school, who, id); },
          [this, id = m_talkedAbout->id](const core::Result<database::AttemptTalk>& talk) {
              if (!m_talkedAbout || m_talkedAbout->id != id)
                  return;
              if (talk) {
                  m_window.scorePage().talk().setTalk(*talk);
                  if (std::exchange(m_reads, {}) == database::AttemptId{id})
                      m_window.scorePage().showTalk();
                  m_window.scorePage().setGiven(talk->overrides.empty() ? std::nullopt
                                                                        : talk->overrides.back().givenTenths);
                  if (m_talkedAbout->person == m_who().person() && !(talk->comments.empty() && talk->overrides.empty()))
                      noteSeen(*m_talkedAbout);
                  if (m_talkedAbout->person == m_person)  // the list behind it says the same
                      tellAttempts();
              } else
                  refuse(talk.error());
          });
}

void AttemptHistoryController::followReplay(const std::optional<database::AttemptRecord>& played)
{
    m_played = played;
    tellRemarks();
}

/// What was said of moments of the attempt that is played; where that cannot be read now, it is played without.
void AttemptHistoryController::tellRemarks()
{
    if (!m_played || m_played->id == 0)
        return;
    askAs([who = m_who(), id = database::AttemptId{m_played->id}](
              const DatabaseContext& school) { return database::sql::readTalk(school, who, id); },
          [this, id = m_played->id](const core::Result<database::AttemptTalk>& talk) {
              if (talk && m_played && m_played->id == id)
                  m_window.setRemarks(remarksOf(*talk));
          });
}

/// Marks feedback as seen. The home page and the list then show it as new no longer.
void AttemptHistoryController::noteSeen(const database::AttemptRecord& attempt)
{
    askAs(
        [who = m_who(), attempt](const DatabaseContext& school) -> core::Result<std::vector<database::Feedback>> {
            if (auto seen = database::sql::seeFeedback(school, who, attempt); !seen)
                return tl::unexpected(seen.error());
            return database::sql::feedbackFor(school, who, who.person());
        },
        [this](const core::Result<std::vector<database::Feedback>>& feedback) {
            if (!feedback)
                return;  // it is told once more
            m_window.setFeedback(*feedback);
            if (m_person == m_who().person())
                m_window.historyPage().setFeedback(*feedback);
        });
}

void AttemptHistoryController::connectReport()
{
    ClassPage& classes = m_window.classPage();
    connect(&classes, &ClassPage::pdfRequested, this, [this, &classes] {
        const QString name =
            QString::fromStdString(m_overview.name) + QDate::currentDate().toString(QStringLiteral(", yyyy-MM-dd"));
        ui::report::askForPdf(&m_window, tr("Save the class report"), name, [this, &classes](const QString& path) {
            withReport([&classes, path](const ui::report::ClassReport& report) {
                const bool isSaved = ui::report::savePdf(path, report.className, report);
                classes.say([isSaved, path] {
                    return isSaved ? tr("The report was saved as %1.").arg(QDir::toNativeSeparators(path))
                                   : tr("The report could not be written. Choose another folder, or make room on the "
                                        "disk.");
                });
            });
        });
    });
    connect(&classes, &ClassPage::tableRequested, this, [this, &classes](const QString& path) {
        withReport([&classes, path, csv = classes.csv()](const ui::report::ClassReport&) { classes.save(path, csv); });
    });
    connect(&classes, &ClassPage::printRequested, this, [this, &classes] {
        const auto onPaper = [this, &classes](const std::shared_ptr<QPagedPaintDevice>& printer) {
            withReport([&classes, printer](const ui::report::ClassReport& report) {
                const bool isPrinted = ui::report::paintOn(*printer, report);
                classes.say([isPrinted] {
                    return isPrinted ? tr("The report was printed.") : tr("The printer did not take the report.");
                });
            });
        };
        if (!ui::report::askForPrinter(&m_window, QString::fromStdString(m_overview.name), onPaper))
            classes.say([] { return tr("There is no printer on this computer. Save it as a PDF instead."); });
    });
}

/// Of the class as it is shown now: another may be by the time that the audit has answered.
ui::report::ClassReport AttemptHistoryController::report() const
{
    ui::report::ClassReport report;
    report.className = QString::fromStdString(m_overview.name);
    report.teacher = QString::fromStdString(m_who().fullName());
    report.overview = m_overview;
    report.given = m_given;
    report.titles = m_titles;
    report.results = m_results;
    if (const lessons::Lesson* known = lesson(m_results.lessonId)) {
        report.passMarkTenths = known->rubric.passMarkTenths;
        report.rubricTitle = known->rubric.title;
        report.rubricVersion = known->rubric.version;
        report.rubricHash = known->rubric.hash;
        report.criteria = criteriaOf(known->rubric);
    }
    return report;
}

/// With the head of the audit as it is now, so that paper and database can be compared.
void AttemptHistoryController::withReport(const std::function<void(const ui::report::ClassReport&)>& use)
{
    if (m_overview.id != m_window.classPage().chosenClass())  // it is not there yet
        return;
    m_window.classPage().say([] { return tr("The report is being written …"); });
    askAs(
        [who = m_who(),
         ofClass = m_overview.id](const DatabaseContext& school) -> core::Result<database::sql::AuditHead> {
            if (const auto noted = database::sql::noteClassExport(school, who, ofClass); !noted)
                return tl::unexpected(noted.error());
            return database::sql::auditHead(school);
        },
        [this, use, report = report()](const core::Result<database::sql::AuditHead>& head) mutable {
            if (!head) {
                m_window.classPage().say(
                    [error = head.error()] { return text::errorText(error, text::FailedOperation::Reporting); });
                return;
            }
            report.proof = {QString::fromStdString(head->code()), QStringLiteral(CUSP_VERSION),
                            QDateTime::currentDateTime()};
            m_window.classPage().repaint();  // so that it is seen what goes on: writing takes a while
            use(report);
        });
}

bool AttemptHistoryController::playsTalkedAbout() const
{
    return m_played && m_talkedAbout && m_played->uid == m_talkedAbout->uid;
}

/// Of who made the attempt that is played, the newest at the same work first.
void AttemptHistoryController::offerBeside(const std::string& lesson, const std::string& tooth)
{
    readLessons([this, lesson, tooth, uid = m_played ? m_played->uid : std::string(),
                 person = m_played && m_played->person.value != 0 ? m_played->person : m_who().person()] {
        askAs([who = m_who(),
               person](const DatabaseContext& school) { return database::sql::history(school, who, person, {}); },
              [this, lesson, tooth, uid](core::Result<std::vector<database::AttemptRecord>>& found) {
                  std::vector<database::AttemptRecord> others;
                  if (found)
                      others = std::move(*found);
                  std::erase_if(others, [uid](const auto& one) { return one.uid == uid || one.recordingHash.empty(); });
                  std::stable_partition(others.begin(), others.end(), [&](const auto& one) {
                      return one.lessonId == lesson && (!lesson.empty() || one.tooth == tooth);
                  });
                  others.resize(std::min(others.size(), kMostBesides));
                  tellBesides(others);
              });
    });
}

void AttemptHistoryController::tellBesides(const std::vector<database::AttemptRecord>& attempts)
{
    QList<ui::kit::MessageBar::Choice> choices;
    for (const database::AttemptRecord& attempt : attempts) {
        const QString name = QStringLiteral("%1, %2").arg(ui::text::lessonTitle(m_titles, attempt.lessonId),
                                                          ui::text::when(attempt.finishedUtc));
        //: %1: a lesson, and when it was done
        choices.push_back(
            {tr("%1: %2 points").arg(name, text::points(attempt.countingTenths())), [this, id = attempt.id, name] {
                 fetch(id, [this, name](const auto&, const auto& recording) { emit besideRequested(recording, name); });
             }});
    }
    m_window.offerBeside(choices);
}

void AttemptHistoryController::refuse(const core::Error& error)
{
    if (isOfAnotherNow(error))
        m_window.showWarning(tr("This belongs to none of your classes any more. An admin can enter you into the class "
                                "again."));
    else
        m_window.showError(error, text::FailedOperation::ReadingSchool);
}

void AttemptHistoryController::openHistory(database::PersonId person, const QString& fullName,
                                           const std::optional<std::string>& lesson)
{
    m_asked = person;
    m_names[person.value] = fullName;
    const auto show = [this, person, fullName, lesson,
                       isStillThere = isStillThere()](const core::Result<AttemptsNow>& found) {
        if (!found) {
            refuse(found.error());
            return;
        }
        if (person != m_asked || !isStillThere())
            return;
        m_person = person;
        HistoryPage& page = m_window.historyPage();
        page.setPerson(fullName);
        showAttempts(page, *found);
        tellWaiting();
        page.setLesson(lesson);
        if (lesson)
            tellClassAt(QString::fromStdString(*lesson));
        m_window.openHistory();
    };
    readLessons([this, person, show] {
        askAs([who = m_who(), person](const DatabaseContext& school) { return readAttempts(school, who, person); },
              show);
    });
}

/// What was said of one of them, perhaps at another computer, has changed the list.
void AttemptHistoryController::tellAttempts()
{
    askAs(
        [who = m_who(), person = m_person](const DatabaseContext& school) { return readAttempts(school, who, person); },
        [this, person = m_person](const core::Result<AttemptsNow>& found) {
            if (!found)
                refuse(found.error());
            else if (person == m_person)
                showAttempts(m_window.historyPage(), *found);
            tellWaiting();
        });
}

/// One's own: of others' this computer tells nobody.
void AttemptHistoryController::tellWaiting()
{
    m_window.historyPage().setWaiting(0);
    if (m_person == m_who().person())
        m_desk.countWaiting(this, m_who(), [this, who = m_who()](int count) {
            if (m_who() == who && m_person == who.person())
                m_window.historyPage().setWaiting(count);
        });
}

/// How the class of the person whose attempts are shown did at a lesson.
void AttemptHistoryController::tellClassAt(const QString& lesson)
{
    struct Found
    {
        std::vector<database::BandPoint> band;
        std::optional<database::LessonMedians> medians;
    };
    askAs(
        [who = m_who(), person = m_person,
         id = lesson.toStdString()](const DatabaseContext& school) -> core::Result<Found> {
            auto band = database::sql::classBand(school, who, person, id);
            auto medians = database::sql::classMedians(school, who, person, id);
            if (!band || !medians)
                return tl::unexpected(band ? medians.error() : band.error());
            return Found{std::move(*band), *medians};
        },
        [this, id = lesson.toStdString()](const core::Result<Found>& found) {
            HistoryPage& page = m_window.historyPage();
            if (!found || page.lesson() != id)
                return;
            page.setBand(found->band);
            page.setClassMedians(found->medians
                                     ? std::optional(ui::scoring::ClassMedians{
                                           found->medians->people, found->medians->tenths, found->medians->durationMs})
                                     : std::nullopt);
        });
}

void AttemptHistoryController::openClasses()
{
    readLessons([this, isStillThere = isStillThere()] {
        tellClasses([this, isStillThere] {
            if (!isStillThere())
                return;
            ClassPage& page = m_window.classPage();
            const bool isShown = page.isVisible();  // otherwise it is read when it is shown
            m_window.openClasses();
            if (isShown)
                page.readAgain();
        });
    });
}

void AttemptHistoryController::tellClasses(const std::function<void()>& then)
{
    askAs([who = m_who()](const DatabaseContext& school) { return database::sql::listClasses(school, who); },
          [this, then](const core::Result<std::vector<database::SchoolClass>>& classes) {
              if (!classes) {
                  tellUnlisted(classes.error());
                  return;
              }
              m_window.classPage().setClasses(QList<database::SchoolClass>(classes->begin(), classes->end()));
              if (then)
                  then();
          });
}

/// Those that were listed before stay.
void AttemptHistoryController::tellUnlisted(const core::Error& error)
{
    ClassPage& page = m_window.classPage();
    if (error.code == core::ErrorCode::NotAllowed || !page.isVisible() || page.isRead()) {
        refuse(error);
        return;
    }
    page.refuse([error] { return text::errorText(error, text::FailedOperation::ReadingSchool); });
    m_again.start();
}

void AttemptHistoryController::openAssign()
{
    readLessons([this, isStillThere = isStillThere()] {
        askAs([who = m_who(), ofClass = m_window.classPage().chosenClass()](
                  const DatabaseContext& school) { return readClass(school, who, ofClass); },
              [this, isStillThere](const core::Result<ClassNow>& now) {
                  if (!now) {
                      refuse(now.error());
                      return;
                  }
                  if (!isStillThere())
                      return;
                  m_window.assignPage().setAssignments(
                      now->overview, QList<database::ClassAssignment>(now->given.begin(), now->given.end()));
                  m_window.openAssign();
              });
    });
}

/// Those before one that is refused have been done.
void AttemptHistoryController::changeAssignments(const QList<ui::people::AssignmentChange>& changes)
{
    askAs(
        [who = m_who(), changes](const DatabaseContext& school) -> core::Result<bool> {
            for (const ui::people::AssignmentChange& change : changes) {
                const core::Status done = change.after
                                              ? database::sql::assign(school, who, *change.after, change.before)
                                              : database::sql::unassign(school, who, *change.before);
                if (!done)
                    return tl::unexpected(done.error());
            }
            return true;
        },
        [this, changes](const core::Result<bool>& done) {
            AssignPage& page = m_window.assignPage();
            if (done)
                page.confirm(changes);
            else
                page.refuse(text::errorText(done.error(), text::FailedOperation::ChangingSchool));
            tellOverview(page.ofClass());
        });
}

void AttemptHistoryController::tellOverview(database::ClassId ofClass)
{
    askAs([who = m_who(), ofClass](const DatabaseContext& school) { return readClass(school, who, ofClass); },
          [this, ofClass](const core::Result<ClassNow>& now) {
              ClassPage& page = m_window.classPage();
              if (!now) {
                  tellUnread(ofClass, now.error());
                  return;
              }
              const QList<database::ClassAssignment> given(now->given.begin(), now->given.end());
              if (m_window.assignPage().ofClass() == ofClass)
                  m_window.assignPage().setAssignments(now->overview, given);
              if (page.chosenClass() != ofClass)
                  return;
              if (page.isVisible())
                  m_window.forgetUnread();
              // What another class did is not this one's, neither shown nor printed.
              if (m_overview.id != now->overview.id || page.chosenLesson().isEmpty())
                  m_results = {};
              m_overview = toldApart(now->overview);
              m_given = given;
              page.setOverview(m_overview);
              page.setAssignments(m_given);
              if (!page.chosenLesson().isEmpty())
                  tellResults(page.chosenLesson());
          });
}

/// Of a class that is shown already what was read before stays; in the place of any other stands that it is not there.
void AttemptHistoryController::tellUnread(database::ClassId ofClass, const core::Error& error)
{
    ClassPage& page = m_window.classPage();
    if (error.code == core::ErrorCode::NotAllowed) {  // the class is no longer theirs
        refuse(error);
        tellClasses();
        return;
    }
    if (page.chosenClass() != ofClass || page.isRead()) {
        refuse(error);
        return;
    }
    page.refuse([error] { return text::errorText(error, text::FailedOperation::ReadingSchool); });
    m_again.start();
}

void AttemptHistoryController::tellResults(const QString& lesson)
{
    const database::ClassId ofClass = m_window.classPage().chosenClass();
    askAs([who = m_who(), ofClass, id = lesson.toStdString()](
              const DatabaseContext& school) { return database::sql::lessonResults(school, who, ofClass, id); },
          [this, ofClass, lesson](const core::Result<database::LessonResults>& results) {
              ClassPage& page = m_window.classPage();
              if (!results || page.chosenClass() != ofClass || page.chosenLesson() != lesson)
                  return;
              m_results = *results;
              const lessons::Lesson* known = this->lesson(m_results.lessonId);
              page.setResults(*results, known != nullptr ? known->rubric.passMarkTenths : 0,
                              known != nullptr ? criteriaOf(known->rubric) : std::map<std::string, QString>());
          });
}

void AttemptHistoryController::fetch(qint64 attempt, const UseAttempt& use, const UseRecord& orElse)
{
    struct Found
    {
        database::AttemptRecord attempt;
        core::Result<core::recording::Recording> recording;
    };
    askAs(
        [who = m_who(), id = database::AttemptId{attempt}](const DatabaseContext& school) -> core::Result<Found> {
            auto record = database::sql::openAttempt(school, who, id);
            if (!record)
                return tl::unexpected(record.error());
            const auto bytes = database::sql::openRecording(school, who, id);
            if (!bytes && !isOfTheRecording(bytes.error().code))
                return tl::unexpected(bytes.error());
            if (!bytes)
                return Found{std::move(*record), tl::unexpected(bytes.error())};
            return Found{std::move(*record), core::recording::Recording::fromBytes(
                                                 {bytes->constData(), static_cast<std::size_t>(bytes->size())})};
        },
        [this, use, orElse, isStillThere = isStillThere()](const core::Result<Found>& found) {
            if (!found) {
                refuse(found.error());
                return;
            }
            if (!isStillThere()) {
                m_reads = {};
                return;
            }
            if (found->recording)
                use(found->attempt, *found->recording);
            else if (orElse)
                orElse(found->attempt);
            else if (found->recording.error().code == core::ErrorCode::FileMissing)
                m_window.showMessage(tr("The recording of this attempt is not there, so it cannot be shown again. Its "
                                        "score and its figures are in the list."));
            else
                refuse(found->recording.error());
        });
}

}  // namespace app
