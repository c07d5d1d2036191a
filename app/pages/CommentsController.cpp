// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/CommentsController.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ui/scoring/CommentsPanel.h"
#include "ui/scoring/ScorePage.h"
#include "ui/text/PeopleTexts.h"
#include "ui/text/Texts.h"

namespace app {
namespace {

using database::AttemptId;
using database::AttemptRecord;
using database::Login;
using database::Repositories;
using ui::scoring::CommentsPanel;
using ui::scoring::ScorePage;
using ui::window::MainWindow;

/// The comments that have a moment, in order of time.
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

}  // namespace

QString makerAndTime(const QString& maker, const AttemptRecord& attempt)
{
    return QStringLiteral("%1, %2").arg(maker, ui::text::when(attempt.finishedUtc));
}

CommentsController::CommentsController(MainWindow& window, UserQueries queries)
    : m_window(window), m_queries(std::move(queries))
{
    connectPanel();
}

void CommentsController::connectPanel()
{
    CommentsPanel& panel = m_window.scorePage().talk();
    connect(&panel, &CommentsPanel::commentRequested, this,
            [this](const QString& words, std::optional<std::int64_t> momentMs,
                   const std::optional<std::array<double, 3>>& placeMm) {
                change([comment = database::NewComment{words.toStdString(), placeMm, momentMs}](
                           const Repositories& school, const Login& who, AttemptId id) {
                    return school.comments.add(who, id, comment);
                });
            });
    connect(&panel, &CommentsPanel::withdrawRequested, this, &CommentsController::withdraw);
    connect(&panel, &CommentsPanel::overrideRequested, this,
            [this](std::optional<int> tenths, const QString& reason, std::size_t before) {
                change([tenths, before, reason = reason.toStdString()](const Repositories& school, const Login& who,
                                                                       AttemptId id) {
                    return school.comments.giveScore(who, id, tenths, reason, before);
                });
            });
    connect(&panel, &CommentsPanel::momentRequested, &m_window.scorePage(), &ui::scoring::ScorePage::momentRequested);
    connect(&m_window.replayView(), &ui::window::ReplayView::shown, this, [this, &panel](double seconds) {
        if (replaysOpenAttempt())
            panel.setMoment(std::llround(1000.0 * seconds));
    });
}

void CommentsController::forget()
{
    open({}, {});
    m_replayed.reset();
    m_scrollsTo = {};
}

void CommentsController::open(const std::optional<AttemptRecord>& attempt, const QString& maker)
{
    m_attempt = attempt;
    m_maker = maker;
    ScorePage& page = m_window.scorePage();
    page.setTalkVisible(attempt.has_value());
    page.talk().setAttempt(attempt ? attempt->id : 0);
    if (!attempt)
        return;
    page.talk().setScore(attempt->scoreTenths, attempt->passMarkTenths, attempt->passed);
    const Login who = m_queries.who();
    page.setMayTalk(who.role() == database::Role::Instructor && attempt->person != who.person());
    page.talk().setTalk({});
    readComments();
    readHistory();
}

QString CommentsController::makerAndTime() const
{
    return m_attempt ? app::makerAndTime(m_maker, *m_attempt) : QString();
}

/// Makes a change to the open attempt, and reads its comments again. If it is refused, shows why beside the input.
template <class Work>
void CommentsController::change(Work work)
{
    if (!m_attempt)
        return;
    m_queries.ask(
        this,
        [id = AttemptId{m_attempt->id}, work = std::move(work)](const Repositories& school, const Login& who) {
            return work(school, who, id);
        },
        [this, attempt = m_attempt->id, whose = makerAndTime()](const core::Status& done) {
            if (done)
                m_window.scorePage().talk().answer(attempt);
            if (done || done.error().code == core::ErrorCode::ChangedSince)
                readComments();
            if (!done) {
                const QString sentence = whyNotDone(done.error());
                m_window.scorePage().talk().answer(attempt, sentence);
                showRefusal(attempt, whose, sentence);
            }
        });
}

QString CommentsController::whyNotDone(const core::Error& error) const
{
    if (!m_queries.hasLostAccess(error))
        return ui::text::errorText(error, ui::text::FailedOperation::ChangingSchool);
    return tr("That was not done: this student is in none of your classes any more. What you have typed stays here; an "
              "admin can enter you into the class again.");
}

/// The panel shows the sentence at the attempt. If the user has left that page, shows it in a message too.
void CommentsController::showRefusal(qint64 attempt, const QString& whose, const QString& sentence)
{
    ScorePage& page = m_window.scorePage();
    if (!page.isVisible() || page.talk().attempt() != attempt)
        //: %1: who made an attempt, and when; %2: why
        m_window.showWarning(tr("On the attempt of %1: %2").arg(whose, sentence));
}

/// Withdraws a comment. If it was withdrawn on another computer already, it disappears here as well.
void CommentsController::withdraw(qint64 comment)
{
    if (!m_attempt)
        return;
    m_queries.ask(
        this,
        [comment](const Repositories& school, const Login& who) -> core::Result<bool> {
            const auto done = school.comments.withdraw(who, comment);
            if (!done && done.error().code != core::ErrorCode::ChangedSince)
                return tl::unexpected(done.error());
            return done.has_value();
        },
        [this, comment, attempt = m_attempt->id, whose = makerAndTime()](const core::Result<bool>& done) {
            if (!done) {
                const QString sentence = whyNotDone(done.error());
                m_window.scorePage().talk().keepComment(comment, attempt, sentence);
                showRefusal(attempt, whose, sentence);
                return;
            }
            m_window.scorePage().talk().withdraw(comment, !*done);
            readComments();
        });
}

/// Reads the attempts before the open one, at the same lesson or, without a lesson, at the same tooth. Until they are
/// known, the page does not call it the first.
void CommentsController::readHistory()
{
    m_window.scorePage().setKeeping(ScorePage::Keeping::Pending);
    m_queries.ask(
        this,
        [person = m_attempt->person,
         query = database::HistoryQuery{m_attempt->lessonId, m_attempt->lessonId.empty() ? m_attempt->tooth : ""}](
            const Repositories& school, const Login& who) { return school.attempts.history(who, person, query); },
        [this, id = m_attempt->id](const core::Result<std::vector<AttemptRecord>>& found) {
            if (!m_attempt || m_attempt->id != id)
                return;
            if (!found) {
                emit readFailed(found.error());
                return;
            }
            const auto opened =
                std::find_if(found->begin(), found->end(), [id](const auto& attempt) { return attempt.id == id; });
            if (opened == found->end())
                return;
            m_window.scorePage().setHistory({opened, found->end()});
            m_window.scorePage().setKeeping(ScorePage::Keeping::Kept);
        });
}

void CommentsController::readComments()
{
    if (!m_attempt)
        return;
    m_queries.ask(
        this,
        [id = AttemptId{m_attempt->id}](const Repositories& school, const Login& who) {
            return school.comments.list(who, id);
        },
        [this, id = m_attempt->id](const core::Result<database::AttemptTalk>& talk) {
            if (!m_attempt || m_attempt->id != id)
                return;
            if (!talk) {
                emit readFailed(talk.error());
                return;
            }
            ScorePage& page = m_window.scorePage();
            page.talk().setTalk(*talk);
            if (std::exchange(m_scrollsTo, {}) == AttemptId{id})
                page.showTalk();
            page.setGiven(talk->overrides.empty() ? std::nullopt : talk->overrides.back().givenTenths);
            const bool isOwn = m_attempt->person == m_queries.who().person();
            if (isOwn && !(talk->comments.empty() && talk->overrides.empty()))
                markSeen();
            emit commentsRead(m_attempt->person);
        });
}

/// The user's home page and list of attempts no longer call the comments new.
void CommentsController::markSeen()
{
    m_queries.ask(
        this,
        [attempt = *m_attempt](const Repositories& school,
                               const Login& who) -> core::Result<std::vector<database::Feedback>> {
            if (auto seen = school.comments.markSeen(who, attempt); !seen)
                return tl::unexpected(seen.error());
            return school.comments.feedbackFor(who, who.person());
        },
        [this](const core::Result<std::vector<database::Feedback>>& feedback) {
            if (feedback)  // otherwise the comments are called new once more
                emit feedbackSeen(*feedback);
        });
}

bool CommentsController::replaysOpenAttempt() const
{
    return m_replayed && m_attempt && m_replayed->uid == m_attempt->uid;
}

void CommentsController::followReplay(const std::optional<AttemptRecord>& replayed)
{
    m_replayed = replayed;
    readRemarks();
}

/// Shows the comments in the replay. If they cannot be read, the replay runs without them.
void CommentsController::readRemarks()
{
    if (!m_replayed || m_replayed->id == 0)
        return;
    m_queries.ask(
        this,
        [id = AttemptId{m_replayed->id}](const Repositories& school, const Login& who) {
            return school.comments.list(who, id);
        },
        [this, id = m_replayed->id](const core::Result<database::AttemptTalk>& talk) {
            if (talk && m_replayed && m_replayed->id == id)
                m_window.replayView().setRemarks(remarksOf(*talk));
        });
}

}  // namespace app
