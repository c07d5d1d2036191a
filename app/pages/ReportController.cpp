// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/ReportController.h"

#include <memory>

#include <QDateTime>
#include <QDir>
#include <QPagedPaintDevice>
#include <QTimer>

#include "database/AuditHead.h"
#include "database/ClassOverview.h"
#include "database/Repositories.h"
#include "ui/report/Printing.h"
#include "ui/scoring/ScorePage.h"
#include "ui/text/Texts.h"

namespace app {
namespace {

using database::AttemptRecord;
using database::Repositories;
using ui::scoring::ScoreCard;
using ui::scoring::ScorePage;

constexpr int kChartedAttempts = 30;

/// What the database holds about a saved attempt.
struct Known
{
    AttemptRecord attempt;
    database::AttemptTalk talk;
    std::vector<AttemptRecord> history;
    std::vector<database::BandPoint> band;
    database::AuditHead head;
};

core::Result<Known> readCard(const Repositories& school, const database::Login& who, const AttemptRecord& attempt)
{
    Known known;
    const database::PersonId person = attempt.id != 0 ? attempt.person : who.person();
    auto history = school.attempts.history(
        who, person, {attempt.lessonId, attempt.lessonId.empty() ? attempt.tooth : "", kChartedAttempts});
    if (!history)
        return tl::unexpected(history.error());
    known.history = std::move(*history);
    // An attempt that was graded just now does not have its id yet.
    database::AttemptId id{attempt.id};
    for (const AttemptRecord& one : known.history)
        if (one.uid == attempt.uid)
            id.value = one.id;
    auto record = school.attempts.open(who, id);
    if (!record)
        return tl::unexpected(record.error());
    known.attempt = std::move(*record);
    auto talk = school.comments.list(who, id);
    if (!talk)
        return tl::unexpected(talk.error());
    known.talk = std::move(*talk);
    if (!attempt.lessonId.empty()) {
        auto band = school.attempts.classBand(who, person, attempt.lessonId);
        if (!band)
            return tl::unexpected(band.error());
        known.band = std::move(*band);
    }
    const auto head = school.audit.head();
    if (!head)
        return tl::unexpected(head.error());
    known.head = *head;
    return known;
}

}  // namespace

ReportController::ReportController(ui::window::MainWindow& window, std::function<std::optional<Subject>()> subject)
    : m_window(window), m_subject(std::move(subject))
{
    connect(&m_window.scorePage(), &ScorePage::pdfRequested, this, &ReportController::save);
    connect(&m_window.scorePage(), &ScorePage::printRequested, this, &ReportController::print);
}

QString ReportController::titleOf(const ScoreCard& card) const
{
    return tr("Score card: %1").arg(card.lesson);
}

void ReportController::save()
{
    const std::optional<Subject> about = m_subject();
    const QString name = (about && !about->person.isEmpty() ? about->person + QStringLiteral(", ") : QString()) +
                         m_window.scorePage().card().lesson +
                         QDate::currentDate().toString(QStringLiteral(", yyyy-MM-dd"));
    ui::report::askForPdf(&m_window, tr("Save the score card"), name, [this](const QString& path) {
        withCard([this, path](const ScoreCard& card) {
            const bool isSaved = ui::report::savePdf(path, titleOf(card), card);
            m_window.scorePage().say([isSaved, path] {
                return isSaved
                           ? tr("The score card was saved as %1.").arg(QDir::toNativeSeparators(path))
                           : tr("The score card could not be written. Choose another folder, or free some disk space.");
            });
        });
    });
}

void ReportController::print()
{
    const auto onPaper = [this](const std::shared_ptr<QPagedPaintDevice>& printer) {
        withCard([this, printer](const ScoreCard& card) {
            const bool isPrinted = ui::report::paintOn(*printer, card);
            m_window.scorePage().say([isPrinted] {
                return isPrinted ? tr("The score card was printed.") : tr("The score card could not be printed.");
            });
        });
    };
    if (!ui::report::askForPrinter(&m_window, titleOf(m_window.scorePage().card()), onPaper))
        m_window.scorePage().say([] { return tr("There is no printer on this computer. Save it as a PDF instead."); });
}

/// Calls `use` with the card that is shown. It names the newest row of the audit, so that paper and database can be
/// compared.
void ReportController::withCard(const std::function<void(const ScoreCard&)>& use)
{
    const std::optional<Subject> about = m_subject();
    if (!about)
        return;
    ScorePage& page = m_window.scorePage();
    page.say([] { return tr("Creating the score card …"); });
    ScoreCard card = page.card();
    card.attempt = about->attempt;
    card.person = about->person.isEmpty() ? tr("Not logged in") : about->person;
    card.proof = {{}, QStringLiteral(CUSP_VERSION), QDateTime::currentDateTime()};
    if (about->school == nullptr) {
        QTimer::singleShot(0, this, [&page, card, use] {
            page.repaint();  // shows the message before the work, which takes a while
            use(card);
        });
        return;
    }
    about->school->ask(
        this,
        [who = about->by, attempt = about->attempt](const Repositories& school) {
            return readCard(school, who, attempt);
        },
        [&page, card, use](const core::Result<Known>& known) mutable {
            if (!known) {
                page.say([error = known.error()] {
                    return ui::text::errorText(error, ui::text::FailedOperation::Reporting);
                });
                return;
            }
            card.attempt = known->attempt;
            card.talk = known->talk;
            card.history = QList<AttemptRecord>(known->history.begin(), known->history.end());
            card.band = known->band;
            card.proof.auditCode = QString::fromStdString(known->head.code());
            page.repaint();
            use(card);
        });
}

}  // namespace app
