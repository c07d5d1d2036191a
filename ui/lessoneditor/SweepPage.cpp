// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessoneditor/SweepPage.h"

#include <algorithm>
#include <utility>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/kit/Accessibility.h"
#include "ui/kit/FileDialog.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/StandardFolders.h"
#include "ui/kit/Theme.h"
#include "ui/lessoneditor/SweepChart.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/LessonTexts.h"

namespace ui::lessoneditor {

using namespace ui::kit;

namespace {

QString howToBegin()
{
    return SweepPage::tr(
        "Choose a folder with recordings of this tooth: each is replayed once, and its score is drawn for tolerances "
        "from 0 to 3 times those at the left.");
}

std::string idsOf(const ::lessons::Rubric& rubric)
{
    std::string ids;
    for (const ::lessons::CriterionRule& rule : rubric.criteria)
        ids += rule.id + ' ';
    return ids;
}

}  // namespace

SweepPage::SweepPage(QWidget* parent) : QWidget(parent), m_measuring(std::make_shared<std::atomic<int>>(0))
{
    m_pool.setMaxThreadCount(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace2);
    auto* row = new QHBoxLayout;
    auto* folder = new QPushButton(this);
    folder->setAutoDefault(true);
    text::bindTranslation(folder, [folder] {
        folder->setText(tr("Recordings …"));
        folder->setToolTip(tr("Choose the folder with recordings of attempts"));
        folder->setAccessibleName(tr("Choose the folder with recordings"));
    });
    folder->setObjectName(QStringLiteral("sweepFolder"));
    connect(folder, &QPushButton::clicked, this, &SweepPage::askForFolder);
    row->addWidget(folder);
    m_swept = kit::choiceInput({}, this);
    text::bindTranslation(m_swept, [this] { kit::nameInput(m_swept, tr("Whose tolerance is changed")); });
    m_swept->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_swept->setMinimumContentsLength(12);
    connect(m_swept, &QComboBox::activated, this, &SweepPage::sweepAgain);
    row->addWidget(m_swept, 1);
    column->addLayout(row);
    auto* work = new QHBoxLayout;
    m_progress = new QProgressBar(this);
    m_progress->setTextVisible(false);
    text::bindTranslation(m_progress, [this] { m_progress->setAccessibleName(tr("Recordings that are replayed")); });
    m_stop = new QPushButton(this);
    m_stop->setAutoDefault(true);
    text::bindTranslation(m_stop, [this] { m_stop->setText(tr("Stop")); });
    m_stop->setProperty("kind", "quiet");
    text::bindTranslation(m_stop, [this] {
        m_stop->setAccessibleName(tr("Stop replaying"));
        m_stop->setToolTip(tr("Go on with those that are done"));
    });
    connect(m_stop, &QPushButton::clicked, this, [this] {
        if (m_cancel)
            m_cancel->store(true);
        m_stop->setEnabled(false);
    });
    work->addWidget(m_progress, 1);
    work->addWidget(m_stop);
    column->addLayout(work);
    m_progress->hide();
    m_stop->hide();
    m_chart = new SweepChart(this);
    column->addWidget(m_chart, 1);
    m_words = kit::formWords({}, kSmall, QFont::Normal, QPalette::PlaceholderText, this);
    m_words->setObjectName(QStringLiteral("sweepWords"));
    column->addWidget(m_words);
    connect(m_chart, &SweepChart::pointedAt, this,
            [this](const QString& there) { m_words->setText(there.isEmpty() ? m_summary : there); });
    connect(m_chart, &SweepChart::saved, this, [this](const QString& sentence) {
        m_words->setText(sentence);
        announce(*m_words);
    });
    begin({});
    text::bindTranslation(this, [this] { retranslateUi(); });
}

void SweepPage::retranslateUi()
{
    if (m_swept->count() > 0)
        nameCriteria();
    sayHowToBegin();
    sweepAgain();
}

void SweepPage::nameCriteria()
{
    m_swept->setItemText(0, tr("All tolerances"));
    int row = 0;
    for (const ::lessons::CriterionRule& rule : m_good->assignment->rubric.criteria)
        m_swept->setItemText(++row, text::titleOf(rule));
}

void SweepPage::sayHowToBegin()
{
    say(howToBegin());
}

SweepPage::~SweepPage()
{
    if (m_cancel)
        m_cancel->store(true);
    ++*m_measuring;
    m_pool.waitForDone();
}

void SweepPage::begin(const std::optional<::lessons::Lesson>& opened)
{
    m_opened = opened;
    m_good.reset();
    m_known.clear();
    m_unmeasured = 0;
    m_measured.clear();
    m_measuredFor.reset();
    ++*m_measuring;
    m_criteriaOffered.clear();
    m_swept->clear();
    m_chart->setSweep({});
    sayHowToBegin();
}

void SweepPage::setKnown(std::vector<MeasuredAttempt> attempts)
{
    m_known = std::move(attempts);
    // Attempts without measured values would have no score under any tolerance.
    const auto measured = std::remove_if(m_known.begin(), m_known.end(),
                                         [](const MeasuredAttempt& attempt) { return attempt.values.empty(); });
    m_unmeasured = static_cast<int>(m_known.end() - measured);
    m_known.erase(measured, m_known.end());
    sweepAgain();
}

void SweepPage::setDraft(const std::shared_ptr<const EvaluatedDraft>& good)
{
    m_good = good;
    const ::lessons::Rubric& rubric = m_good->assignment->rubric;
    if (const std::string ids = idsOf(rubric); std::exchange(m_criteriaOffered, ids) != ids) {
        m_swept->clear();
        for (std::size_t k = 0; k <= rubric.criteria.size(); ++k)
            m_swept->addItem({});
        nameCriteria();
    }
    measureLater();
}

void SweepPage::askForFolder()
{
    auto* dialog = new kit::FileDialog(this, tr("Choose the folder with recordings"), kit::documentsFolder());
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, this, &SweepPage::readFolder);
    dialog->open();
}

void SweepPage::readFolder(const QString& folder)
{
    if (m_cancel)
        m_cancel->store(true);
    m_cancel = std::make_shared<std::atomic<bool>>(false);
    const int reading = ++m_reading;
    m_progress->setRange(0, 0);
    m_progress->show();
    m_stop->setEnabled(true);
    m_stop->show();
    // The destructor waits for the pool, so `this` is valid. It also removes queued calls.
    const auto later = [this, reading](auto what) {
        QMetaObject::invokeMethod(
            this,
            [this, reading, what] {
                if (reading == m_reading)
                    what();
            },
            Qt::QueuedConnection);
    };
    m_pool.start([this, later, folder, cancel = m_cancel] {
        const auto told = [&](int done, int of) {
            later([this, done, of] {
                m_progress->setRange(0, std::max(1, of));
                m_progress->setValue(done);
            });
        };
        const auto past = std::make_shared<const PastAttempts>(readAttempts(folder, told, *cancel));
        later([this, past] { takeAttempts(past); });
    });
}

void SweepPage::takeAttempts(const std::shared_ptr<const PastAttempts>& past)
{
    m_past = past;
    m_progress->hide();
    m_stop->hide();
    m_measured.clear();
    m_measuredFor.reset();
    m_words->setToolTip(brokenIntoLines(past->faults.join(u'\n')));
    measureLater();
}

/// Measures the attempts against this ideal if that has not been done. Otherwise grades them with the measured values.
void SweepPage::measureLater()
{
    if (!m_good)
        return;
    const core::grading::IdealTop ideal = m_good->assignment->shownIdeal();
    if (!m_past || (m_measuredFor && m_measuredFor == ideal)) {
        sweepAgain();
        return;
    }
    m_measuredFor = ideal;
    const int number = ++*m_measuring;
    m_pool.start([this, number, newest = m_measuring, good = m_good, past = m_past] {
        if (*newest != number)
            return;
        const auto measured =
            std::make_shared<std::vector<MeasuredAttempt>>(measureAttempts(*good->assignment, past->attempts));
        QMetaObject::invokeMethod(
            this,
            [this, number, measured] {
                if (*m_measuring != number)
                    return;
                m_measured = std::move(*measured);
                sweepAgain();
            },
            Qt::QueuedConnection);
    });
}

/// Returns whether ideal, tooth and lesion are unchanged since the lesson was opened. The saved values of attempts are
/// valid only then.
bool SweepPage::isAsOpened() const
{
    const ::lessons::Lesson& lesson = *m_good->assignment->lesson;
    return m_opened && m_opened->ideal == lesson.ideal && m_opened->tooth == lesson.tooth &&
           m_opened->lesion == lesson.lesion && m_opened->leeway == lesson.leeway;
}

void SweepPage::sweepAgain()
{
    if (!m_good)
        return;
    const bool countsKnown = isAsOpened() && !m_known.empty();
    std::vector<MeasuredAttempt> attempts = m_measured;
    if (countsKnown)
        attempts.insert(attempts.end(), m_known.begin(), m_known.end());
    m_chart->setSweep(sweepOf(m_good->assignment->rubric, attempts, m_swept->currentIndex() - 1));
    QStringList said;
    if (!attempts.empty())
        said << m_chart->words(1.0) + u'.';
    else if (m_past)
        said << tr("No attempt in this folder was made at this tooth.");
    else if (!m_known.empty())
        said << tr("The attempts of the history were made for another ideal than this draft's. Choose a folder with "
                   "recordings.");
    else if (m_unmeasured > 0)
        said << howToBegin();
    else
        return;  // a message says what to do
    if (countsKnown)
        said << tr("%n of them from the history.", nullptr, static_cast<int>(m_known.size()));
    if (m_unmeasured > 0)
        said << tr("%n attempt(s) of the history without measured values are left out.", nullptr, m_unmeasured);
    const int others = m_past ? static_cast<int>(m_past->attempts.size() - m_measured.size()) : 0;
    if (!m_measured.empty() && others > 0)
        said << tr("%n attempt(s) at other teeth are left out.", nullptr, others);
    if (m_past && !m_past->faults.isEmpty())
        said << tr("%n recording(s) could not be read.", nullptr, static_cast<int>(m_past->faults.size()));
    say(said.join(u' '));
}

void SweepPage::say(const QString& words)
{
    m_summary = words;
    m_words->setText(words);
}

}  // namespace ui::lessoneditor
