// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/AttemptHistoryController.h"

#include <algorithm>
#include <utility>

#include <QPointer>

#include "app/pages/PageGuard.h"
#include "lessons/Assignment.h"
#include "lessons/ScoreSheetJson.h"
#include "ui/admin/AdminPage.h"
#include "ui/catalog/LessonsPage.h"
#include "ui/kit/MessageBar.h"
#include "ui/people/HistoryPage.h"
#include "ui/scoring/ScorePage.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/LessonTexts.h"
#include "ui/text/PeopleTexts.h"
#include "ui/text/Texts.h"

namespace app {
namespace {

constexpr std::size_t kMostBesides = 12;  ///< attempts to choose from

namespace text = ui::text;
using database::AttemptId;
using database::AttemptRecord;
using database::Login;
using database::PersonId;
using database::Repositories;
using ui::people::HistoryPage;
using ui::window::MainWindow;

/// The attempts of one person.
struct Attempts
{
    std::vector<AttemptRecord> saved;
    std::vector<database::ExamStart> withoutScore;
    std::vector<database::Feedback> feedback;
};

core::Result<Attempts> readAttempts(const Repositories& school, const Login& who, PersonId person)
{
    auto saved = school.attempts.history(who, person, {});
    auto withoutScore = school.attempts.examsWithoutScore(who, person);
    auto feedback = school.comments.feedbackFor(who, person);
    if (!saved || !withoutScore)
        return tl::unexpected(saved ? withoutScore.error() : saved.error());
    if (!feedback)
        return tl::unexpected(feedback.error());
    return Attempts{std::move(*saved), std::move(*withoutScore), std::move(*feedback)};
}

void showAttempts(HistoryPage& page, const Attempts& attempts)
{
    page.setExamsWithoutScore({attempts.withoutScore.begin(), attempts.withoutScore.end()});
    page.setHistory({attempts.saved.begin(), attempts.saved.end()});
    page.setFeedback(attempts.feedback);
}

/// The stored score sheet of an attempt. If there is none, a sheet of what the record holds.
/// @param rubric  of the lesson, as it is today; null: there is none
lessons::ScoreSheet sheetOf(const AttemptRecord& attempt, const lessons::Rubric* rubric)
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

/// Whether an error says that the recording is missing or damaged, while the attempt itself can be shown.
bool isOfTheRecording(core::ErrorCode code)
{
    using core::ErrorCode;
    return code == ErrorCode::FileMissing || code == ErrorCode::FileUnreadable || code == ErrorCode::BadStructure;
}

/// An attempt and its recording, or why there is no readable one.
struct OpenedAttempt
{
    AttemptRecord attempt;
    core::Result<core::recording::Recording> recording;
};

core::Result<OpenedAttempt> openAttempt(const Repositories& school, const Login& who, AttemptId id)
{
    auto record = school.attempts.open(who, id);
    if (!record)
        return tl::unexpected(record.error());
    const auto bytes = school.attempts.recording(who, id);
    if (!bytes && !isOfTheRecording(bytes.error().code))
        return tl::unexpected(bytes.error());
    if (!bytes)
        return OpenedAttempt{std::move(*record), tl::unexpected(bytes.error())};
    return OpenedAttempt{std::move(*record), core::recording::Recording::fromBytes(
                                                 {bytes->constData(), static_cast<std::size_t>(bytes->size())})};
}

}  // namespace

AttemptHistoryController::AttemptHistoryController(MainWindow& window, SchoolAccess& school, std::function<Login()> who)
    : m_window(window), m_queries(school, who), m_lessons(std::move(who)), m_comments(window, m_queries),
      m_classes(window, m_queries, m_lessons)
{
    connectHistory();
    connectParts();
}

void AttemptHistoryController::connectHistory()
{
    HistoryPage& page = m_window.historyPage();
    connect(&m_window.navigation(), &ui::window::Navigation::attemptsRequested, this,
            [this] { open(m_queries.who().person(), {}, {}); });
    connect(&m_window.lessonsPage(), &ui::catalog::LessonsPage::feedbackRequested, this, [this, &page](qint64 attempt) {
        if (attempt == 0) {
            open(m_queries.who().person(), {}, {});
        } else {
            m_comments.scrollTo({attempt});
            emit page.attemptOpenRequested(attempt);
        }
    });
    connect(&page, &HistoryPage::lessonChosen, this, &AttemptHistoryController::readClassmates);
    connect(&page, &HistoryPage::readAgainRequested, this, &AttemptHistoryController::readAgain);
    connect(&page, &HistoryPage::replayRequested, this, [this](qint64 id) {
        fetch(id, [this](const auto& attempt, const auto& recording) {
            emit replayRequested(recording, attempt, makerAndTime(makerOf(attempt), attempt));
        });
    });
    connect(&page, &HistoryPage::attemptOpenRequested, this, [this](qint64 id) {
        fetch(
            id, [this](const auto& attempt, const auto& recording) { emit scoreRequested(attempt, recording); },
            [this](const auto& attempt) { openSheet(attempt); });
    });
    connect(&m_window.replayView(), &ui::window::ReplayView::besidesRequested, this,
            &AttemptHistoryController::offerBeside);
}

void AttemptHistoryController::connectParts()
{
    HistoryPage& page = m_window.historyPage();
    text::bindTranslation(&page, [lessons = QPointer<LessonNames>(&m_lessons)] {
        if (lessons)
            lessons->translate();
    });
    connect(&m_lessons, &LessonNames::changed, this, [this, &page] {
        page.setLessonTitles(m_lessons.titles());
        page.setCriterionNames(m_lessons.criteria());
        m_window.adminPage().setLessonTitles(m_lessons.titles());
    });
    connect(&m_window.adminPage(), &ui::admin::AdminPage::partOpened, this, [this] {
        if (m_lessons.titles().isEmpty())
            m_lessons.read([] {});
    });
    connect(&m_comments, &CommentsController::readFailed, this, &AttemptHistoryController::showReadError);
    connect(&m_comments, &CommentsController::commentsRead, this, [this](PersonId person) {
        if (person == m_person)
            readAgain();
    });
    connect(&m_comments, &CommentsController::feedbackSeen, this,
            [this, &page](const std::vector<database::Feedback>& feedback) {
                m_window.lessonsPage().setFeedback(feedback);
                if (m_person == m_queries.who().person())
                    page.setFeedback(feedback);
            });
    connect(&m_classes, &ClassController::readFailed, this, &AttemptHistoryController::showReadError);
    connect(&m_classes, &ClassController::attemptsRequested, this, &AttemptHistoryController::open);
}

void AttemptHistoryController::forget()
{
    m_comments.forget();
    m_classes.forget();
    m_requested = {};
    m_person = {};
    m_names.clear();
}

void AttemptHistoryController::talkAbout(const std::optional<AttemptRecord>& attempt)
{
    m_comments.open(attempt, attempt ? makerOf(*attempt) : QString());
}

/// The name of a person whose attempts have been listed: an attempt is opened from a list.
QString AttemptHistoryController::makerOf(const AttemptRecord& attempt) const
{
    const Login who = m_queries.who();
    if (attempt.person == who.person())
        return QString::fromStdString(who.fullName());
    const auto known = m_names.find(attempt.person.value);
    return known != m_names.end() ? known->second : QString();
}

/// Reads the lessons first: the title of a lesson is in its file.
void AttemptHistoryController::openSheet(const AttemptRecord& attempt)
{
    m_lessons.read([this, attempt, isStillThere = pageStaysOpen(m_window)] {
        if (!isStillThere()) {
            m_comments.scrollTo({});
            return;
        }
        const lessons::Lesson* const known = m_lessons.find(attempt.lessonId);
        const auto practice = lessons::practiceRubric();
        const lessons::Rubric* const rubric = known != nullptr                       ? &known->rubric
                                              : attempt.lessonId.empty() && practice ? &*practice
                                                                                     : nullptr;
        emit sheetRequested(attempt, sheetOf(attempt, rubric),
                            [self = QPointer<AttemptHistoryController>(this), attempt] {
                                return self ? self->workOf(attempt) : QString();
                            });
    });
}

/// The title of its lesson, or its tooth.
QString AttemptHistoryController::workOf(const AttemptRecord& attempt) const
{
    if (const lessons::Lesson* known = m_lessons.find(attempt.lessonId))
        return text::said(known->title);
    const QString title = text::lessonTitle({}, attempt.lessonId);
    return attempt.lessonId.empty() ? QStringLiteral("%1, %2").arg(title, QString::fromStdString(attempt.tooth))
                                    : title;
}

/// Offers other attempts of the person whose attempt is replayed, those at the same work first.
void AttemptHistoryController::offerBeside(const std::string& lesson, const std::string& tooth)
{
    const std::optional<AttemptRecord>& replayed = m_comments.replayed();
    m_lessons.read([this, lesson, tooth, uid = replayed ? replayed->uid : std::string(),
                    person = replayed && replayed->person.value != 0 ? replayed->person : m_queries.who().person()] {
        m_queries.ask(
            this,
            [person](const Repositories& school, const Login& who) { return school.attempts.history(who, person, {}); },
            [this, lesson, tooth, uid](core::Result<std::vector<AttemptRecord>>& found) {
                std::vector<AttemptRecord> others;
                if (found)
                    others = std::move(*found);
                std::erase_if(others, [uid](const auto& one) { return one.uid == uid || one.recordingHash.empty(); });
                std::stable_partition(others.begin(), others.end(), [&](const auto& one) {
                    return one.lessonId == lesson && (!lesson.empty() || one.tooth == tooth);
                });
                others.resize(std::min(others.size(), kMostBesides));
                showBesides(others);
            });
    });
}

void AttemptHistoryController::showBesides(const std::vector<AttemptRecord>& attempts)
{
    QList<ui::kit::MessageBar::Choice> choices;
    for (const AttemptRecord& attempt : attempts) {
        const QString name = QStringLiteral("%1, %2").arg(text::lessonTitle(m_lessons.titles(), attempt.lessonId),
                                                          text::when(attempt.finishedUtc));
        //: %1: a lesson, and when it was done
        choices.push_back(
            {tr("%1: %2 points").arg(name, text::points(attempt.countingTenths())), [this, id = attempt.id, name] {
                 fetch(id, [this, name](const auto&, const auto& recording) { emit besideRequested(recording, name); });
             }});
    }
    m_window.replayView().offerBeside(choices);
}

void AttemptHistoryController::showReadError(const core::Error& error)
{
    if (m_queries.hasLostAccess(error))
        m_window.showWarning(tr("This belongs to none of your classes any more. An admin can enter you into the class "
                                "again."));
    else
        m_window.showError(error, text::FailedOperation::ReadingSchool);
}

void AttemptHistoryController::open(PersonId person, const QString& fullName, const std::optional<std::string>& lesson)
{
    m_requested = person;
    m_names[person.value] = fullName;
    const auto show = [this, person, fullName, lesson,
                       isStillThere = pageStaysOpen(m_window)](const core::Result<Attempts>& found) {
        if (!found) {
            showReadError(found.error());
            return;
        }
        if (person != m_requested || !isStillThere())
            return;
        m_person = person;
        HistoryPage& page = m_window.historyPage();
        page.setPerson(fullName);
        showAttempts(page, *found);
        showWaiting();
        page.setLesson(lesson);
        if (lesson)
            readClassmates(QString::fromStdString(*lesson));
        m_window.navigation().openHistory();
    };
    m_lessons.read([this, person, show] {
        m_queries.ask(
            this, [person](const Repositories& school, const Login& who) { return readAttempts(school, who, person); },
            show);
    });
}

/// Reads the list again: it shows which attempts have comments, also those from other computers.
void AttemptHistoryController::readAgain()
{
    m_queries.ask(
        this,
        [person = m_person](const Repositories& school, const Login& who) { return readAttempts(school, who, person); },
        [this, person = m_person](const core::Result<Attempts>& found) {
            if (!found)
                showReadError(found.error());
            else if (person == m_person)
                showAttempts(m_window.historyPage(), *found);
            showWaiting();
        });
}

/// Shows how many of the user's own attempts wait on this computer. Those of others are not counted.
void AttemptHistoryController::showWaiting()
{
    m_window.historyPage().setWaiting(0);
    const Login who = m_queries.who();
    if (m_person == who.person())
        m_queries.school().countWaiting(this, who, [this, who](int count) {
            if (m_queries.who() == who && m_person == who.person())
                m_window.historyPage().setWaiting(count);
        });
}

/// Shows how the classmates of the listed person do at a lesson.
void AttemptHistoryController::readClassmates(const QString& lesson)
{
    struct Classmates
    {
        std::vector<database::BandPoint> band;
        std::optional<database::LessonMedians> medians;
    };
    m_queries.ask(
        this,
        [person = m_person, id = lesson.toStdString()](const Repositories& school,
                                                       const Login& who) -> core::Result<Classmates> {
            auto band = school.attempts.classBand(who, person, id);
            auto medians = school.attempts.classMedians(who, person, id);
            if (!band || !medians)
                return tl::unexpected(band ? medians.error() : band.error());
            return Classmates{std::move(*band), *medians};
        },
        [this, id = lesson.toStdString()](const core::Result<Classmates>& found) {
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

void AttemptHistoryController::fetch(qint64 attempt, const UseAttempt& use, const UseRecord& orElse)
{
    m_queries.ask(
        this,
        [id = AttemptId{attempt}](const Repositories& school, const Login& who) {
            return openAttempt(school, who, id);
        },
        [this, use, orElse, isStillThere = pageStaysOpen(m_window)](const core::Result<OpenedAttempt>& found) {
            if (!found) {
                showReadError(found.error());
                return;
            }
            if (!isStillThere()) {
                m_comments.scrollTo({});
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
                showReadError(found->recording.error());
        });
}

}  // namespace app
