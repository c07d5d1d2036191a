// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/HistoryPage.h"

#include <algorithm>
#include <map>

#include <QButtonGroup>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "database/NameOrder.h"
#include "ui/charts/ChartPanel.h"
#include "ui/kit/Actions.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/ListTable.h"
#include "ui/kit/Theme.h"
#include "ui/people/HistoryModel.h"
#include "ui/text/EveryLanguage.h"

namespace ui::people {
namespace {

using namespace ui::kit;

constexpr int kArrowPx = 18;  ///< width of the sorting arrow
constexpr int kEmptyPx = 460;
constexpr int kLeastTitlePx = 190;
constexpr qsizetype kMostStarts = 3;  ///< number of exams without a score that are listed

enum Which { Criteria, Time, Force, Speed };

}  // namespace

HistoryPage::HistoryPage(const Actions& actions, QWidget* parent)
    : Page(actions, parent), m_model(new HistoryModel(this)), m_filter(new HistoryFilter(m_model)),
      m_stack(new QStackedWidget(this))
{
    auto* full = new QWidget(m_stack);
    auto* row = new QHBoxLayout(full);
    row->setContentsMargins(kSpace2, 0, kSpace2, 0);
    row->setSpacing(kSpace4);
    row->addWidget(makeList(), 3);
    row->addWidget(makeCharts(), 2);
    m_stack->addWidget(full);
    m_stack->addWidget(makeEmpty(actions));
    body()->addWidget(m_stack, 1);
    retell();
}

QWidget* HistoryPage::makeList()
{
    auto* part = new QWidget(m_stack);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace2);
    auto* head = new QHBoxLayout;
    head->setSpacing(kSpace4);
    m_lessons = new QComboBox(part);
    m_lessons->setObjectName(QStringLiteral("lessonFilter"));
    m_lessons->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_lessons->setMinimumContentsLength(26);
    m_lessons->setMinimumHeight(32);
    connect(m_lessons, &QComboBox::currentIndexChanged, this, &HistoryPage::takeLesson);
    m_count = new QLabel(part);
    m_count->setObjectName(QStringLiteral("historyCount"));
    m_count->setTextFormat(Qt::PlainText);
    m_count->setForegroundRole(QPalette::PlaceholderText);
    head->addWidget(m_lessons);
    head->addWidget(m_count, 1);
    column->addLayout(head);
    m_waitingWords = new QLabel(part);
    m_waitingWords->setObjectName(QStringLiteral("attemptsWaiting"));
    m_withoutScore = new QLabel(part);
    m_withoutScore->setObjectName(QStringLiteral("examsWithoutScore"));
    for (QLabel* words : {m_waitingWords, m_withoutScore}) {
        words->setTextFormat(Qt::PlainText);
        words->setWordWrap(true);
        words->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        words->hide();
        column->addWidget(words);
    }

    m_table = new kit::ListTable(part);
    m_table->setObjectName(QStringLiteral("attempts"));
    m_table->setModel(m_filter);
    m_table->sortByColumn(HistoryModel::When, Qt::DescendingOrder);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setAlternatingRowColors(true);
    m_table->verticalHeader()->hide();
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    QHeaderView* columns = m_table->horizontalHeader();
    columns->setSectionResizeMode(QHeaderView::Interactive);
    columns->setSectionResizeMode(HistoryModel::Lesson, QHeaderView::Stretch);
    m_table->setColumnHidden(HistoryModel::Feedback, true);
    m_table->viewport()->installEventFilter(this);
    connect(m_table, &QTableView::activated, this, [this] { m_open->click(); });
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &HistoryPage::updateChosen);
    column->addWidget(m_table, 1);

    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(kSpace2);
    m_missing = new QLabel(part);
    m_missing->setObjectName(QStringLiteral("recordingMissing"));
    m_missing->setTextFormat(Qt::PlainText);
    m_missing->setForegroundRole(QPalette::PlaceholderText);
    m_missing->setWordWrap(true);
    buttons->addWidget(m_missing, 1);
    m_replay = new QPushButton(part);
    m_replay->setObjectName(QStringLiteral("replayAttempt"));
    m_replay->setAutoDefault(true);
    connect(m_replay, &QPushButton::clicked, this, [this] { emit replayRequested(chosen()); });
    m_open = new QPushButton(part);
    m_open->setObjectName(QStringLiteral("openAttempt"));
    m_open->setProperty("kind", "filled");
    m_open->setAutoDefault(true);
    connect(m_open, &QPushButton::clicked, this, [this] { emit attemptOpenRequested(chosen()); });
    buttons->addWidget(m_replay);
    buttons->addWidget(m_open);
    column->addLayout(buttons);
    return part;
}

QWidget* HistoryPage::makeCharts()
{
    auto* part = new QWidget(m_stack);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace4);
    const auto card = [&] {
        auto* frame = new QFrame(part);
        frame->setProperty("kind", "card");
        auto* inside = new QVBoxLayout(frame);
        inside->setContentsMargins(kSpace2, kSpace2, kSpace2, kSpace2);
        inside->setSpacing(kSpace1);
        column->addWidget(frame, 1);
        return inside;
    };
    m_score = new charts::ChartPanel(part);
    m_score->setObjectName(QStringLiteral("scoreChart"));
    card()->addWidget(m_score, 1);

    QVBoxLayout* second = card();
    auto* choice = new QHBoxLayout;
    choice->setSpacing(kSpace1);
    choice->setContentsMargins(kSpace2, 0, kSpace2, 0);
    m_which = new QButtonGroup(this);
    const auto offer = [&](Which which, const auto& say) {
        auto* button = new QPushButton(part);
        button->setProperty("kind", "segment");
        button->setCheckable(true);
        button->setAutoDefault(true);
        text::bindTranslation(button, [button, say] {
            button->setText(say());
            button->setAccessibleName(say());
        });
        m_which->addButton(button, which);
        choice->addWidget(button);
    };
    offer(Criteria, [] { return tr("Criteria"); });
    offer(Time, [] { return tr("Time"); });
    offer(Force, [] { return tr("Force"); });
    //: A chart of speed and accuracy
    offer(Speed, [] { return tr("Speed"); });
    choice->addStretch(1);
    m_which->button(Criteria)->setChecked(true);
    connect(m_which, &QButtonGroup::idClicked, this, &HistoryPage::drawCharts);
    second->addLayout(choice);
    m_other = new charts::ChartPanel(part);
    m_other->setObjectName(QStringLiteral("otherChart"));
    second->addWidget(m_other, 1);
    for (charts::ChartPanel* panel : {m_score, m_other})
        connect(panel, &charts::ChartPanel::chosen, this, &HistoryPage::attemptOpenRequested);
    return part;
}

QWidget* HistoryPage::makeEmpty(const Actions& actions)
{
    auto* part = new QWidget(m_stack);
    auto* column = new QVBoxLayout(part);
    column->setSpacing(kSpace4);
    column->addStretch(1);
    m_emptyTitle = new QLabel(part);
    m_emptyTitle->setFont(typeface(kTitle, QFont::DemiBold));
    m_emptyWords = new QLabel(part);
    m_emptyWords->setObjectName(QStringLiteral("emptyWords"));
    for (QLabel* words : {m_emptyTitle, m_emptyWords}) {
        words->setTextFormat(Qt::PlainText);
        words->setWordWrap(true);
        words->setAlignment(Qt::AlignHCenter);
        words->setFixedWidth(kEmptyPx);
        column->addWidget(words, 0, Qt::AlignHCenter);
    }
    m_start = pageButton(actions.lessons, "filled", part);
    column->addWidget(m_start, 0, Qt::AlignHCenter);
    column->addStretch(2);
    return part;
}

void HistoryPage::forget()
{
    setLesson({});
    setExamsWithoutScore({});
    setWaiting(0);
    setHistory({});
    setFeedback({});
    setPerson({});
}

void HistoryPage::setPerson(const QString& fullName)
{
    m_person = fullName;
    retell();
}

void HistoryPage::setHistory(const QList<database::AttemptRecord>& newestFirst)
{
    const std::int64_t kept = chosen();
    m_history = newestFirst;
    m_model->setAttempts(newestFirst);
    fillLessons();
    takeLesson();
    for (int row = 0; row < m_filter->rowCount() && kept != 0; ++row)
        if (m_model->at(m_filter->mapToSource(m_filter->index(row, 0)).row()).id == kept)
            m_table->setCurrentIndex(m_filter->index(row, 0));
}

void HistoryPage::setExamsWithoutScore(const QList<database::ExamStart>& newestFirst)
{
    m_startsWithoutScore = newestFirst;
    updateWithoutScore();
}

/// Lists the exams without a score in the lesson that is shown.
void HistoryPage::updateWithoutScore()
{
    const auto shown = lesson();
    QStringList starts;
    for (const database::ExamStart& start : m_startsWithoutScore)
        if (!shown || start.lessonId == *shown)
            //: %1: an exam; %2: when it was begun
            starts << tr("%1, begun %2")
                          .arg(text::lessonTitle(m_charted.titles, start.lessonId), text::when(start.begunUtc));
    QStringList words = starts.first(std::min<qsizetype>(starts.size(), kMostStarts));
    if (starts.size() > kMostStarts)
        words << tr("and %n more", nullptr, static_cast<int>(starts.size() - kMostStarts));
    m_withoutScore->setText(tr("Exams that have no score: %1").arg(words.join(QStringLiteral("; "))));
    m_withoutScore->setToolTip(starts.size() > kMostStarts ? starts.join(u'\n') : QString());
    m_withoutScore->setVisible(!starts.isEmpty());
    updateWaiting();
}

void HistoryPage::setWaiting(int count)
{
    m_waiting = count;
    updateWaiting();
}

/// Shows the number of attempts not yet uploaded, and whether the page has any content.
void HistoryPage::updateWaiting()
{
    m_waitingWords->setText(
        tr("%n attempt(s) wait on this computer, and stand here when the school has them.", nullptr, m_waiting));
    m_waitingWords->setVisible(m_waiting > 0);
    m_stack->setCurrentIndex(m_history.isEmpty() && m_startsWithoutScore.isEmpty() && m_waiting == 0 ? 1 : 0);
}

void HistoryPage::setLessonTitles(const text::LessonTitles& titles)
{
    m_charted.titles = titles;
    m_model->setTitles(titles);
    fillLessons();
    updateWithoutScore();
    drawCharts();
}

void HistoryPage::setCriterionNames(const std::map<std::string, text::CriterionNames>& names)
{
    m_charted.criteria = names;
    drawCharts();
}

void HistoryPage::setLesson(const std::optional<std::string>& lessonId)
{
    int index = 0;
    for (int k = 1; k < m_lessons->count() && lessonId; ++k)
        if (m_lessons->itemData(k).toString() == QString::fromStdString(*lessonId))
            index = k;
    m_lessons->setCurrentIndex(index);
}

std::optional<std::string> HistoryPage::lesson() const
{
    if (m_lessons->currentIndex() <= 0)
        return std::nullopt;
    return m_lessons->currentData().toString().toStdString();
}

void HistoryPage::setBand(const std::vector<database::BandPoint>& band)
{
    m_charted.band = band;
    drawCharts();
}

void HistoryPage::setClassMedians(const std::optional<scoring::ClassMedians>& medians)
{
    m_charted.medians = medians;
    drawCharts();
}

/// Fills the list of tried lessons with their counts, and keeps the selection.
void HistoryPage::fillLessons()
{
    const auto kept = lesson();
    std::map<std::string, int> tried;
    for (const database::AttemptRecord& attempt : m_history)
        ++tried[attempt.lessonId];
    QList<std::pair<QString, std::string>> titles;
    for (const auto& [id, count] : tried)
        titles << std::pair(text::lessonTitle(m_charted.titles, id), id);
    std::sort(titles.begin(), titles.end(),
              [order = database::NameOrder()](const auto& a, const auto& b) { return order(a.first, b.first); });
    const QSignalBlocker quiet(m_lessons);
    m_lessons->clear();
    m_lessons->addItem(tr("All lessons"));
    for (const auto& [title, id] : titles) {
        //: %1: a lesson; %2: how many attempts
        m_lessons->addItem(tr("%1 (%2)").arg(title, QString::number(tried[id])), QString::fromStdString(id));
        if (kept && *kept == id)
            m_lessons->setCurrentIndex(m_lessons->count() - 1);
    }
    makeRoom();
}

void HistoryPage::takeLesson()
{
    const auto chosenLesson = lesson();
    m_filter->setLesson(chosenLesson);
    m_charted.isOneLesson = chosenLesson.has_value();
    m_charted.newestFirst.clear();
    for (const database::AttemptRecord& attempt : m_history)
        if (!chosenLesson || attempt.lessonId == *chosenLesson)
            m_charted.newestFirst << attempt;
    m_charted.band.clear();
    m_charted.medians.reset();
    m_count->setText(tr("%n attempt(s)", nullptr, static_cast<int>(m_charted.newestFirst.size())));
    if (m_filter->rowCount() > 0)
        m_table->setCurrentIndex(m_filter->index(0, 0));
    updateChosen();
    updateWithoutScore();
    drawCharts();
    if (chosenLesson)
        emit lessonChosen(QString::fromStdString(*chosenLesson));
}

bool HistoryPage::focusSearch() const
{
    if (!m_lessons->isVisible())
        return false;
    m_lessons->setFocus(Qt::ShortcutFocusReason);
    return true;
}

std::int64_t HistoryPage::chosen() const
{
    const QModelIndexList rows = m_table->selectionModel()->selectedRows();
    return rows.isEmpty() ? 0 : m_model->at(m_filter->mapToSource(rows.front()).row()).id;
}

void HistoryPage::updateChosen()
{
    const QModelIndexList rows = m_table->selectionModel()->selectedRows();
    const auto* attempt = rows.isEmpty() ? nullptr : &m_model->at(m_filter->mapToSource(rows.front()).row());
    const bool isRecorded = attempt != nullptr && !attempt->recordingHash.empty();
    m_open->setEnabled(attempt != nullptr);
    m_replay->setEnabled(isRecorded);
    const QString missing = tr("Of this attempt no recording was kept.");
    const bool isMissing = attempt != nullptr && !isRecorded;
    m_missing->setText(isMissing ? missing : QString());
    m_open->setToolTip(isMissing ? tr("See what cost points") : tr("See what cost points, and where"));
    m_replay->setToolTip(isMissing ? missing : tr("See again how it was done"));
}

void HistoryPage::drawCharts()
{
    const auto chosenLesson = lesson();
    const QString of = chosenLesson ? text::lessonTitle(m_charted.titles, *chosenLesson) : tr("All lessons");
    const auto show = [&](charts::ChartPanel* panel, charts::Chart chart) {
        chart.of = m_person.isEmpty() ? of : QStringLiteral("%1, %2").arg(m_person, of);
        panel->setChart(chart);
    };
    show(m_score, scoring::scoreChart(m_charted));
    switch (m_which->checkedId()) {
    case Time:
        show(m_other, scoring::timeChart(m_charted));
        break;
    case Force:
        show(m_other, scoring::forceChart(m_charted));
        break;
    case Speed:
        show(m_other, scoring::speedChart(m_charted));
        break;
    default:
        show(m_other, scoring::criteriaChart(m_charted));
    }
}

void HistoryPage::retell()
{
    setTitle(m_person.isEmpty() ? tr("My attempts") : tr("Attempts of %1").arg(m_person));
    kit::nameInput(m_lessons, tr("Show the attempts at this lesson"));
    m_table->setAccessibleName(tr("Attempts"));
    m_open->setText(tr("Open grade"));
    m_replay->setText(tr("Replay"));
    for (QPushButton* button : {m_open, m_replay})
        button->setAccessibleName(button->text());
    m_emptyTitle->setText(m_person.isEmpty() ? tr("No attempts yet") : tr("%1 has no attempts yet").arg(m_person));
    m_emptyWords->setText(m_person.isEmpty()
                              ? tr("Here you will find every attempt that was graded: its score, what cost points, "
                                   "time and force, and how it goes from attempt to attempt. Do a lesson and have it "
                                   "graded.")
                              : tr("As soon as an attempt has been graded it is here."));
    // A layout gives an aligned label the height of one line only.
    m_emptyWords->setFixedHeight(m_emptyWords->heightForWidth(kEmptyPx));
    m_start->setVisible(m_person.isEmpty());
    m_model->retell();
    fitColumns();
    fillLessons();
    m_count->setText(tr("%n attempt(s)", nullptr, static_cast<int>(m_charted.newestFirst.size())));
    updateChosen();
    drawCharts();
}

void HistoryPage::setFeedback(const std::vector<database::Feedback>& feedback)
{
    std::map<std::int64_t, bool> isNew;
    for (const database::Feedback& one : feedback)
        isNew[one.attempt.value] = one.isNew;
    m_model->setFeedback(std::move(isNew), m_person.isEmpty());
    m_table->setColumnHidden(HistoryModel::Feedback, feedback.empty());
    makeRoom();
}

/// Makes the columns as wide as their text in the current language. The lesson's column takes the rest.
void HistoryPage::fitColumns()
{
    const QFontMetrics metrics(typeface(kBody));
    const QFontMetrics heads(typeface(kBody, QFont::DemiBold));
    const auto fit = [&](int column, const QStringList& widest) {
        int px =
            heads.horizontalAdvance(m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString()) + kArrowPx;
        for (const QString& words : widest)
            px = std::max(px, metrics.horizontalAdvance(words));
        m_columnPx[column] = px + kSpace6;
        m_table->horizontalHeader()->resizeSection(column, px + kSpace6);
    };
    fit(HistoryModel::When,
        {text::when("2026-12-28T22:58:00Z"), text::when("2026-09-20T20:00:00Z"), text::when("2026-08-04T04:44:00Z")});
    fit(HistoryModel::Score, {QStringLiteral("100.0")});
    fit(HistoryModel::Result, {HistoryModel::tr("passed"), HistoryModel::tr("not passed")});
    fit(HistoryModel::Feedback, {HistoryModel::tr("new"), HistoryModel::tr("unread"), HistoryModel::tr("read")});
    fit(HistoryModel::Time, {QStringLiteral("1:12:07")});
    fit(HistoryModel::Force, {QStringLiteral("10.85 / 12.10")});
    makeRoom();
}

/// Hides the columns for force and time if the titles need the room. Both have charts beside the list.
void HistoryPage::makeRoom()
{
    // The title column needs no more than the longest title.
    const QFontMetrics letters(typeface(kBody));
    int titlePx = 0;
    for (int k = 1; k < m_lessons->count(); ++k)
        titlePx = std::max(titlePx, letters.horizontalAdvance(text::lessonTitle(
                                        m_charted.titles, m_lessons->itemData(k).toString().toStdString())));
    int leftPx = m_table->viewport()->width() - std::min(kLeastTitlePx, titlePx + kSpace6);
    for (const auto& [column, px] : m_columnPx)
        if (column != HistoryModel::Feedback || !m_table->isColumnHidden(column))
            leftPx -= px;
    for (const int column : {HistoryModel::Force, HistoryModel::Time}) {
        m_table->setColumnHidden(column, leftPx < 0);
        if (leftPx < 0)
            leftPx += m_columnPx[column];
        else
            m_table->horizontalHeader()->resizeSection(column, m_columnPx[column]);
    }
}

bool HistoryPage::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        makeRoom();
    return Page::eventFilter(watched, event);
}

void HistoryPage::changeEvent(QEvent* event)
{
    Page::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retell();
}

void HistoryPage::showEvent(QShowEvent* event)
{
    Page::showEvent(event);
    if (m_history.isEmpty())
        m_start->setFocus();
    else
        m_table->setFocus();
}

}  // namespace ui::people
