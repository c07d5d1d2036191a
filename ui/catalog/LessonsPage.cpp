// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/catalog/LessonsPage.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <memory>
#include <utility>

#include <QButtonGroup>
#include <QCoreApplication>
#include <QFileInfo>
#include <QFrame>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QScreen>
#include <QScrollBar>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include "ui/catalog/ExamQuestion.h"
#include "ui/catalog/LessonCards.h"
#include "ui/catalog/LessonPicture.h"
#include "ui/catalog/LessonThumbs.h"
#include "ui/kit/Actions.h"
#include "ui/kit/LineIcon.h"
#include "ui/kit/ScrollPane.h"
#include "ui/kit/Theme.h"
#include "ui/scoring/FeedbackCard.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/LessonTexts.h"
#include "ui/text/Search.h"
#include "ui/text/Texts.h"
#include "ui/text/ValidationTexts.h"
#include "ui/toothchooser/ArchView.h"

namespace ui::catalog {
namespace {

using namespace ui::kit;
using namespace ui::toothchooser;
using ::lessons::CatalogEntry;

constexpr int kDetailsWidthPx = 560;
constexpr int kLeastDetailsPx = 330;
constexpr int kFactWidthPx = 120;
constexpr int kArchPx = 300;

QLabel* label(const QString& words, int size, QFont::Weight weight, QPalette::ColorRole role, QWidget* parent)
{
    auto* made = new QLabel(words, parent);
    made->setTextFormat(Qt::PlainText);  // a teacher's text may look like rich text
    made->setFont(typeface(size, weight));
    made->setForegroundRole(role);
    made->setWordWrap(true);
    return made;
}

QString nameOf(const CatalogEntry& entry)
{
    return entry.read.lesson ? text::said(entry.read.lesson->title) : QFileInfo(entry.read.file).fileName();
}

bool isOnTooth(const CatalogEntry& entry, const QStringList& numbers)
{
    if (!entry.read.lesson)
        return false;
    const auto* made = std::get_if<::lessons::MadeTooth>(&entry.read.lesson->tooth);
    const auto* scan = std::get_if<::lessons::Scan>(&entry.read.lesson->tooth);
    return (made != nullptr && numbers.contains(QString::number(made->fdi))) ||
           (scan != nullptr && numbers.contains(QString::number(scan->fdi)));
}

}  // namespace

LessonsPage::LessonsPage(const Actions& actions, QWidget* parent)
    : Page(actions, parent), m_thumbs(new LessonThumbs(this))
{
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace6);
    row->addWidget(makeList(), 4);
    row->addWidget(makeDetails(actions), 3);
    body()->addLayout(row, 1);
    text::bindTranslation(this, [this] {
        setTitle(tr("Lessons"));
        fillList();
        updateContinue();
        updateFeedback();
        updateMissing();
    });
}

QWidget* LessonsPage::makeList()
{
    auto* side = new QWidget(this);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(kSpace4, 0, 0, 0);
    column->setSpacing(kSpace2);
    column->addLayout(makeSearch(side));
    column->addWidget(makeFilters(side));
    column->addWidget(makeContinue(side));
    m_feedbackCard = new scoring::FeedbackCard(side);
    connect(m_feedbackCard, &scoring::FeedbackCard::readRequested, this,
            [this] { emit feedbackRequested(m_feedback.size() == 1 ? m_feedback.front().attempt.value : 0); });
    column->addWidget(m_feedbackCard);
    makeCards(side);
    column->addWidget(m_list, 1);
    m_missing = label({}, kSmall, QFont::Normal, QPalette::PlaceholderText, side);
    m_missing->hide();
    m_folder = new QPushButton(side);
    m_folder->setObjectName(QStringLiteral("ownLessons"));
    text::bindTranslation(m_folder, [folder = m_folder] {
        folder->setText(tr("Your own lessons …"));
        folder->setToolTip(tr("Open the folder for lessons that teachers add"));
        folder->setAccessibleName(tr("Open the folder of your own lessons"));
    });
    m_folder->setAutoDefault(true);
    m_folder->setProperty("kind", "quiet");
    connect(m_folder, &QPushButton::clicked, this, &LessonsPage::folderRequested);
    auto* below = new QHBoxLayout;
    below->addWidget(m_missing, 1);
    below->addWidget(m_folder, 0, Qt::AlignRight);
    column->addLayout(below);
    return side;
}

QLayout* LessonsPage::makeSearch(QWidget* side)
{
    auto* find = new QHBoxLayout;
    find->setSpacing(kSpace2);
    m_search = new QLineEdit(side);
    text::bindTranslation(m_search, [this] {
        m_search->setPlaceholderText(tr("Search: a word, or the number of a tooth"));
        m_search->setToolTip(m_search->placeholderText());
        m_search->setAccessibleName(tr("Search the lessons"));
    });
    m_search->setClearButtonEnabled(true);
    for (auto* clear : m_search->findChildren<QAbstractButton*>())
        text::bindTranslation(clear, [clear] { clear->setAccessibleName(tr("Clear the search")); });
    m_search->setFont(typeface(kBody));
    m_search->installEventFilter(this);
    m_tooth = new QPushButton(side);
    m_tooth->setObjectName(QStringLiteral("pickTooth"));
    m_tooth->setAutoDefault(true);
    m_tooth->setIcon(lineIcon(QStringLiteral("tooth"), palette()));
    text::bindTranslation(m_tooth, [this] {
        m_tooth->setText(tr("Tooth …"));
        m_tooth->setAccessibleName(tr("Lessons on one tooth"));
        m_tooth->setToolTip(tr("Choose a tooth in the arch to see its lessons"));
    });
    connect(m_tooth, &QPushButton::clicked, this, &LessonsPage::pickTooth);
    find->addWidget(m_search, 1);
    find->addWidget(m_tooth);
    connect(m_search, &QLineEdit::textChanged, this, &LessonsPage::search);
    return find;
}

void LessonsPage::makeCards(QWidget* side)
{
    m_model = new QStandardItemModel(side);
    m_list = new QListView(side);
    m_list->setModel(m_model);
    m_list->setViewMode(QListView::IconMode);
    m_list->setMovement(QListView::Static);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setSpacing(kSpace1);
    m_list->setItemDelegate(new LessonCards(
        *m_thumbs,
        [this](int entry) {
            const auto& lesson = m_entries[static_cast<std::size_t>(entry)].read.lesson;
            return lesson ? &*lesson : nullptr;
        },
        m_list));
    connect(m_thumbs, &LessonThumbs::changed, m_list->viewport(), qOverload<>(&QWidget::update));
    text::bindTranslation(m_list, [this] { m_list->setAccessibleName(tr("Lessons")); });
    m_list->setMouseTracking(true);
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    // The scroll bar's space is reserved, so that cards do not move. It is not drawn if there is nothing to scroll.
    QScrollBar* const bar = m_list->verticalScrollBar();
    connect(bar, &QScrollBar::rangeChanged, bar, [bar](int low, int high) { bar->setEnabled(low < high); });
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setProperty("kind", "plain");
    m_list->setObjectName(QStringLiteral("lessonList"));
    m_list->installEventFilter(this);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, &LessonsPage::describe);
    connect(m_list, &QListView::activated, this, &LessonsPage::start);
    // A click beside the cards does not change the selection.
    connect(m_list->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        if (m_list->currentIndex().isValid() && !m_list->selectionModel()->hasSelection())
            m_list->selectionModel()->select(m_list->currentIndex(), QItemSelectionModel::Select);
    });
}

QWidget* LessonsPage::makeFilters(QWidget* parent)
{
    auto* row = new QWidget(parent);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(kSpace1);
    m_filter = new QButtonGroup(this);
    const auto offer = [&](Filter filter, const auto& say) {
        auto* button = new QPushButton(row);
        button->setProperty("kind", "segment");
        button->setCheckable(true);
        button->setAutoDefault(true);
        text::bindTranslation(button, [button, say] {
            button->setText(say());
            button->setAccessibleName(say());
        });
        m_filter->addButton(button, static_cast<int>(filter));
        line->addWidget(button);
    };
    //: All lessons
    offer(Filter::All, [] { return tr("All"); });
    //: Lessons that are still to be done
    offer(Filter::ToDo, [] { return tr("To do"); });
    //: Lessons that were passed
    offer(Filter::Passed, [] { return tr("Passed"); });
    offer(Filter::Exams, [] { return tr("Exams"); });
    line->addStretch(1);
    m_filter->button(static_cast<int>(Filter::All))->setChecked(true);
    connect(m_filter, &QButtonGroup::idClicked, this, &LessonsPage::fillList);
    return row;
}

QWidget* LessonsPage::makeContinue(QWidget* parent)
{
    m_continue = new QFrame(parent);
    m_continue->setProperty("kind", "card");
    m_continue->setObjectName(QStringLiteral("continueCard"));
    auto* row = new QHBoxLayout(m_continue);
    row->setContentsMargins(kSpace4, kSpace2, kSpace2, kSpace2);
    m_continueWords = label({}, kBody, QFont::Medium, QPalette::WindowText, m_continue);
    m_continueWords->setObjectName(QStringLiteral("continueWords"));
    m_goOn = new QPushButton(m_continue);
    m_goOn->setObjectName(QStringLiteral("continue"));
    m_goOn->setAutoDefault(true);
    row->addWidget(m_continueWords, 1);
    m_discard = new QPushButton(m_continue);
    m_discard->setObjectName(QStringLiteral("discardUnfinished"));
    m_discard->setProperty("kind", "quiet");
    m_discard->setAutoDefault(true);
    text::bindTranslation(m_discard, [this] {
        m_discard->setText(tr("Discard"));
        m_discard->setAccessibleName(tr("Discard the unfinished attempt"));
    });
    row->addWidget(m_discard);
    row->addWidget(m_goOn);
    connect(m_discard, &QPushButton::clicked, this, &LessonsPage::discardRequested);
    connect(m_goOn, &QPushButton::clicked, this, &LessonsPage::goOn);
    m_continue->hide();
    return m_continue;
}

/// Shows the arch below its button until the user picks a tooth. Then searches for the number of that tooth.
void LessonsPage::pickTooth()
{
    auto* popup = new QFrame(this, Qt::Popup);
    popup->setAttribute(Qt::WA_DeleteOnClose);
    popup->setObjectName(QStringLiteral("archPopup"));
    popup->setFrameShape(QFrame::StyledPanel);
    auto* column = new QVBoxLayout(popup);
    auto* arch = new ArchView(popup);
    arch->setFixedSize(kArchPx, arch->minimumSizeHint().height());
    column->addWidget(arch);
    const auto take = [this, popup](int fdi) {
        m_search->setText(QString::number(fdi));
        popup->close();
        m_list->setFocus();
    };
    connect(arch, &ArchView::toothActivated, popup, take);
    // A click picks a tooth at once. The arrow keys only move, and Enter picks.
    arch->installEventFilter(popup);
    for (auto* button : arch->findChildren<ArchTooth*>())
        connect(button, &ArchTooth::clicked, popup, [take, button] { take(button->fdi()); });
    connect(arch, &ArchView::selectionChanged, popup, [take](int fdi) {
        if (fdi != 0 && QGuiApplication::mouseButtons() != Qt::NoButton)
            take(fdi);
    });
    popup->adjustSize();
    const QRect screen = m_tooth->screen()->availableGeometry();
    QPoint at = m_tooth->mapToGlobal(QPoint(m_tooth->width() - popup->width(), m_tooth->height() + kSpace1));
    at.setX(std::clamp(at.x(), screen.left(), std::max(screen.left(), screen.right() - popup->width())));
    at.setY(std::clamp(at.y(), screen.top(), std::max(screen.top(), screen.bottom() - popup->height())));
    popup->move(at);
    popup->show();
    arch->takeFocus();
}

QWidget* LessonsPage::makeDetails(const Actions& actions)
{
    auto* side = new QWidget(this);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, kSpace4, 0);
    column->setSpacing(kSpace4);
    m_title = label({}, kFigure, QFont::DemiBold, QPalette::WindowText, side);
    m_title->setObjectName(QStringLiteral("lessonTitle"));
    m_goal = label({}, kTitle, QFont::Normal, QPalette::WindowText, side);
    m_goal->setMaximumWidth(kDetailsWidthPx);
    column->addWidget(m_title);
    column->addWidget(m_goal);
    m_picture = new LessonPicture(side);
    column->addWidget(m_picture, 100);
    m_factsSlot = new QVBoxLayout;
    column->addLayout(m_factsSlot);
    column->addStretch(1);
    auto* scroll = new ScrollPane(side, QPalette::Window, this);

    auto* whole = new QWidget(this);
    whole->setMinimumWidth(kLeastDetailsPx);
    auto* stack = new QVBoxLayout(whole);
    stack->setContentsMargins(0, 0, 0, 0);
    stack->addWidget(scroll, 1);
    m_whyNot = label({}, kBody, QFont::Normal, QPalette::WindowText, whole);
    m_whyNot->setObjectName(QStringLiteral("whyNotStart"));
    stack->addWidget(m_whyNot);
    auto* buttons = new QHBoxLayout;
    m_start = new QPushButton(whole);
    text::bindTranslation(m_start, [this] { m_start->setText(tr("Start")); });
    m_start->setProperty("kind", "filled");
    text::bindTranslation(m_start, [this] {
        m_start->setAccessibleName(tr("Start this lesson"));
        m_start->setToolTip(tr("Load the tooth of this lesson (Enter)"));
    });
    m_start->setObjectName(QStringLiteral("startLesson"));
    m_start->setAutoDefault(true);
    connect(m_start, &QPushButton::clicked, this, &LessonsPage::start);
    buttons->addWidget(m_start);
    m_edit = pageButton(actions.editLesson, "", whole);
    buttons->addWidget(m_edit);
    buttons->addStretch(1);
    stack->addLayout(buttons);
    return whole;
}

void LessonsPage::setLessons(std::vector<CatalogEntry> entries, std::map<std::string, Standing> standings,
                             std::map<std::string, Given> given)
{
    m_entries = std::move(entries);
    m_standings = std::move(standings);
    m_given = std::move(given);
    // Order: assigned lessons that are not passed, by due date; then the others by group; invalid files last. Equal
    // ones are in the order of their files.
    std::stable_sort(m_entries.begin(), m_entries.end(), [this](const CatalogEntry& a, const CatalogEntry& b) {
        const auto place = [this](const CatalogEntry& entry) {
            using Place = std::pair<std::pair<int, std::string>, qint64>;
            constexpr int kLast = 100;
            if (entry.isFaulty())
                return Place({kLast, {}}, 0);
            if (!isToDo(entry))
                return Place(text::groupPlace(*entry.read.lesson), 0);
            const QDateTime due = givenOf(entry)->due;
            return Place({-1, {}}, due.isValid() ? due.toMSecsSinceEpoch() : std::numeric_limits<qint64>::max());
        };
        return place(a) < place(b);
    });
    fillList();
    updateContinue();
    updateMissing();
}

const Standing* LessonsPage::standingOf(const CatalogEntry& entry) const
{
    const auto found = entry.read.lesson ? m_standings.find(entry.read.lesson->id) : m_standings.end();
    return found == m_standings.end() ? nullptr : &found->second;
}

const Given* LessonsPage::givenOf(const CatalogEntry& entry) const
{
    const auto found = entry.read.lesson ? m_given.find(entry.read.lesson->id) : m_given.end();
    return found == m_given.end() ? nullptr : &found->second;
}

/// Returns whether a teacher has assigned the lesson and the student has not passed it yet.
bool LessonsPage::isToDo(const CatalogEntry& entry) const
{
    const Standing* const standing = standingOf(entry);
    return givenOf(entry) != nullptr && (standing == nullptr || !standing->passed);
}

void LessonsPage::setUnfinished(const std::function<QString()>& title, const QDateTime& begun)
{
    m_unfinished = title;
    m_unfinishedBegun = begun;
    updateContinue();
}

/// Returns whether the student has used all attempts at the lesson.
bool LessonsPage::isUsedUp(const CatalogEntry& entry) const
{
    const Given* const given = givenOf(entry);
    return given != nullptr && given->attemptsLeft && *given->attemptsLeft <= 0;
}

/// Returns the lesson tried last if it was never passed and can be tried again, otherwise null.
const CatalogEntry* LessonsPage::lastTried() const
{
    const CatalogEntry* last = nullptr;
    for (const CatalogEntry& entry : m_entries)
        if (const Standing* const standing = standingOf(entry);
            standing != nullptr && (last == nullptr || standing->lastUtc > standingOf(*last)->lastUtc))
            last = &entry;
    return last != nullptr && !standingOf(*last)->passed && !isUsedUp(*last) ? last : nullptr;
}

void LessonsPage::updateContinue()
{
    const CatalogEntry* const last = lastTried();
    m_continue->setVisible(m_unfinished || last != nullptr);
    m_goOn->setText(tr("Continue"));
    m_discard->setVisible(static_cast<bool>(m_unfinished));
    if (m_unfinished) {
        //: %1: a lesson or a tooth; %2: a time of today, or a day and a time
        m_continueWords->setText(tr("Continue %1, started %2").arg(m_unfinished(), text::shortWhen(m_unfinishedBegun)));
    } else if (last != nullptr) {
        //: %1: a lesson; %2: points
        m_continueWords->setText(
            tr("Last attempt: %1, best so far %2")
                .arg(text::said(last->read.lesson->title), text::points(standingOf(*last)->bestTenths)));
        m_goOn->setText(tr("Try again"));
    }
    m_goOn->setAccessibleName(m_goOn->text());
}

void LessonsPage::goOn()
{
    if (m_unfinished)
        emit resumeRequested();
    else if (const CatalogEntry* const last = lastTried(); last != nullptr)
        choose(*last->read.lesson);
}

void LessonsPage::setFeedback(const std::vector<database::Feedback>& feedback)
{
    m_feedback.clear();
    std::copy_if(feedback.begin(), feedback.end(), std::back_inserter(m_feedback),
                 [](const database::Feedback& one) { return one.isNew; });
    updateFeedback();
}

void LessonsPage::updateFeedback()
{
    if (m_feedback.empty()) {
        m_feedbackCard->setNews(0, {}, {});
        return;
    }
    const database::Feedback& newest = m_feedback.front();
    const auto entry = std::find_if(m_entries.begin(), m_entries.end(), [&](const CatalogEntry& one) {
        return !one.isFaulty() && one.read.lesson->id == newest.lessonId;
    });
    m_feedbackCard->setNews(static_cast<int>(m_feedback.size()),
                            entry != m_entries.end() ? text::said(entry->read.lesson->title)
                                                     : QString::fromStdString(newest.lessonId),
                            QString::fromStdString(newest.author));
}

/// Lists assigned lessons whose file is missing: a teacher's own lesson may exist only on that teacher's computer.
void LessonsPage::updateMissing()
{
    QStringList missing;
    for (const auto& [id, given] : m_given)
        if (std::none_of(m_entries.begin(), m_entries.end(), [&id = id](const CatalogEntry& entry) {
                return entry.read.lesson && entry.read.lesson->id == id;
            }))
            missing << QString::fromStdString(id);
    m_missing->setText(tr("Assigned to you, but not on this computer: %1. Ask your teacher for the file.")
                           .arg(missing.join(QStringLiteral(", "))));
    m_missing->setVisible(!missing.isEmpty() && !m_entries.empty());
}

void LessonsPage::forget()
{
    m_search->clear();
    m_filter->button(static_cast<int>(Filter::All))->setChecked(true);
    fillList();
    m_list->setCurrentIndex({});  // the next list selects its own first card
}

void LessonsPage::setPresent(const std::string& lessonId)
{
    m_present = lessonId;
    fillList();
}

void LessonsPage::setMayEdit(bool may)
{
    m_mayEdit = may;
    const CatalogEntry* entry = chosen();
    m_edit->setVisible(may && entry != nullptr && entry->read.lesson.has_value());
    m_folder->setVisible(may);
}

void LessonsPage::setUnsaved(const QSet<QString>& files)
{
    if (std::exchange(m_unsaved, files) != files)
        fillList();
}

bool LessonsPage::isWanted(const CatalogEntry& entry) const
{
    const Standing* const standing = standingOf(entry);
    const bool isPassed = standing != nullptr && standing->passed;
    switch (static_cast<Filter>(m_filter->checkedId())) {
    case Filter::All:
        return true;
    case Filter::ToDo:
        return entry.read.lesson && (m_given.empty() ? !isPassed : isToDo(entry));
    case Filter::Passed:
        return isPassed;
    case Filter::Exams:
        return entry.read.lesson && entry.read.lesson->exam;
    }
    return true;
}

void LessonsPage::fillCard(QStandardItem& item, const CatalogEntry& entry) const
{
    const auto& lesson = entry.read.lesson;
    QStringList notes{lesson ? text::toothWords(*lesson) : tr("Invalid file")};
    if (m_unsaved.contains(entry.read.file))
        //: Of a lesson in a list: in the editor
        notes.prepend(tr("changed, not saved"));
    item.setData(notes.join(QStringLiteral(" · ")), CardTooth);
    item.setToolTip(notes.join(u'\n'));  // a card has little room
    if (!lesson) {
        item.setData(item.data(CardTooth), Qt::AccessibleDescriptionRole);
        return;
    }
    if (lesson->exam)
        notes << tr("exam");
    item.setData(lesson->exam, CardIsExam);
    item.setData(lesson->id == m_present, CardMarked);
    const Standing* const standing = standingOf(entry);
    const bool isPassed = standing != nullptr && standing->passed;
    if (const Given* const given = givenOf(entry)) {
        const QDateTime now = QDateTime::currentDateTime();
        QStringList due{given->className};
        if (given->due.isValid())
            due.prepend(isPassed ? text::dueDayWords(given->due, now) : text::dueWords(given->due, now));
        item.setData(due.join(QStringLiteral(" · ")), CardDue);
        item.setData(isUsedUp(entry), CardIsUsedUp);
        if (isUsedUp(entry))
            due.prepend(QCoreApplication::translate("Lesson", "no attempts left"));
        item.setData(given->due.isValid() && given->due < now && !isPassed, CardIsLate);
        notes << due;
        item.setToolTip(item.toolTip() + u'\n' + due.join(u'\n'));
    }
    if (standing != nullptr) {
        const QString points = text::points(standing->bestTenths);
        item.setData(isPassed ? QStringLiteral("✓ ") + points : points, CardScore);
        item.setData(isPassed, CardPassed);
        //: For a screen reader: the best score of a lesson
        notes << (isPassed ? tr("best %1, passed") : tr("best %1, not passed")).arg(points);
    }
    item.setData(notes.join(QStringLiteral(", ")), Qt::AccessibleDescriptionRole);
}

/// Returns the text in which a lesson is searched. It does not contain dates or points.
QString LessonsPage::searchedWords(const CatalogEntry& entry) const
{
    const auto& lesson = entry.read.lesson;
    if (!lesson)
        return nameOf(entry) + u' ' + tr("Invalid file");
    QStringList words{nameOf(entry), text::toothWords(*lesson), text::groupName(*lesson), text::said(lesson->goal),
                      QString::fromStdString(lesson->id)};
    if (lesson->exam)
        words << tr("exam");
    if (const Given* const given = givenOf(entry))
        words << given->className;
    return words.join(u' ');
}

/// Returns the matching entries, which contain every word. Entries on a tooth whose number is one of the words come
/// first.
std::vector<std::size_t> LessonsPage::found() const
{
    const QStringList words = m_search->text().split(u' ', Qt::SkipEmptyParts);
    std::vector<std::size_t> shown;
    for (std::size_t k = 0; k < m_entries.size(); ++k) {
        if (isWanted(m_entries[k]) && text::holdsEach(searchedWords(m_entries[k]), m_search->text()))
            shown.push_back(k);
    }
    std::stable_partition(shown.begin(), shown.end(), [&](std::size_t k) { return isOnTooth(m_entries[k], words); });
    return shown;
}

void LessonsPage::fillList()
{
    const CatalogEntry* before = chosen();
    const std::string kept = before != nullptr && before->read.lesson ? before->read.lesson->id : m_present;
    m_model->clear();
    QString group;
    QModelIndex select;
    for (const std::size_t k : found()) {
        const CatalogEntry& entry = m_entries[k];
        const auto& lesson = entry.read.lesson;
        auto item = std::make_unique<QStandardItem>(nameOf(entry));
        item->setData(static_cast<int>(k), CardEntry);
        fillCard(*item, entry);
        const QString heading = isToDo(entry) ? tr("Assigned to you")
                                : lesson      ? text::groupName(*lesson)
                                              : tr("Invalid file");
        if (heading != group) {
            auto* head = new QStandardItem(heading);
            head->setFlags(Qt::NoItemFlags);
            m_model->appendRow(head);
            group = heading;
        }
        m_model->appendRow(item.get());
        const QModelIndex index = item.release()->index();
        if (!select.isValid() || (lesson && lesson->id == kept))
            select = index;
    }
    m_list->setCurrentIndex(select);
    m_list->scrollTo(select);
    describe();
}

/// Searches, and selects the first match, so that Enter starts it.
void LessonsPage::search()
{
    fillList();
    if (m_search->text().trimmed().isEmpty())
        return;
    m_list->setCurrentIndex(m_model->index(std::min(1, m_model->rowCount() - 1), 0));  // below its heading
    m_list->scrollToTop();
}

const CatalogEntry* LessonsPage::chosen() const
{
    const QVariant entry = m_list->currentIndex().data(CardEntry);
    return entry.isValid() ? &m_entries[static_cast<std::size_t>(entry.toInt())] : nullptr;
}

void LessonsPage::begin(const ::lessons::Lesson& lesson, const std::function<void()>& begin)
{
    if (lesson.exam)
        emit examAsked(examQuestion(lesson, attemptsWords(lesson.id), begin));
    else
        begin();
}

void LessonsPage::choose(const ::lessons::Lesson& lesson)
{
    begin(lesson, [this, lesson] { emit lessonChosen(lesson); });
}

/// Returns how often a lesson was graded and how many attempts are left, for example "1 attempt(s) left, 2 graded so
/// far".
QString LessonsPage::attemptsWords(const std::string& lessonId) const
{
    const auto given = m_given.find(lessonId);
    const auto standing = m_standings.find(lessonId);
    const auto left = given != m_given.end() ? given->second.attemptsLeft : std::nullopt;
    QString words = left ? tr("%n attempt(s) left", nullptr, *left) : tr("no limit");
    if (standing != m_standings.end())
        //: Of attempts at a lesson; follows "2 attempts left, "
        words += QStringLiteral(", ") + tr("%1 graded so far").arg(QLocale().toString(standing->second.attempts));
    return words;
}

void LessonsPage::setAttemptsLeft(const std::string& lessonId, std::optional<int> left)
{
    if (const auto given = m_given.find(lessonId); given != m_given.end())
        given->second.attemptsLeft = left;
}

void LessonsPage::takeScore(int tenths, bool passed)
{
    Standing& standing = m_standings[m_present];
    ++standing.attempts;
    standing.bestTenths = std::max(standing.bestTenths, tenths);
    standing.passed = standing.passed || passed;
}

const ::lessons::Lesson* LessonsPage::next() const
{
    const CatalogEntry* present = nullptr;
    for (const CatalogEntry& entry : m_entries)
        if (entry.read.lesson && entry.read.lesson->id == m_present)
            present = &entry;
    for (const CatalogEntry& entry : m_entries)
        if (&entry != present && isToDo(entry) && !isUsedUp(entry))
            return &*entry.read.lesson;
    if (present == nullptr)
        return nullptr;
    // In the order of the catalog, because assigned lessons have been moved to the front of this list.
    const auto place = [](const CatalogEntry& entry) { return std::pair(!entry.isShipped, entry.read.file); };
    const auto group = text::groupPlace(*present->read.lesson);
    const CatalogEntry* after = nullptr;
    for (const CatalogEntry& entry : m_entries)
        if (entry.read.lesson && text::groupPlace(*entry.read.lesson) == group && place(entry) > place(*present) &&
            !isUsedUp(entry) && (after == nullptr || place(entry) < place(*after)))
            after = &entry;
    return after != nullptr ? &*after->read.lesson : nullptr;
}

void LessonsPage::startNext()
{
    if (const ::lessons::Lesson* const lesson = next(); lesson != nullptr)
        choose(*lesson);
}

void LessonsPage::describe()
{
    delete m_facts;
    m_facts = new QWidget(this);
    auto* grid = new QGridLayout(m_facts);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kSpace6);
    grid->setVerticalSpacing(kSpace2);
    grid->setColumnMinimumWidth(0, kFactWidthPx);
    grid->setColumnStretch(1, 1000);
    grid->setColumnStretch(2, 1);  // the rest of the width
    m_factsSlot->addWidget(m_facts);
    const CatalogEntry* entry = chosen();
    const bool isSound = entry != nullptr && entry->read.lesson.has_value();
    const bool isOver = isSound && isUsedUp(*entry);
    m_start->setEnabled(isSound && !isOver);
    m_whyNot->setText(text::usedUpWords());
    m_whyNot->setVisible(isOver);
    m_picture->setLesson(isSound ? entry->read.lesson : std::nullopt);
    m_edit->setVisible(isSound && m_mayEdit);
    const bool isSearched = !m_search->text().trimmed().isEmpty();
    const bool isEmpty = m_entries.empty();  // shipped lessons always exist, so the list has not been read yet
    m_title->setText(isEmpty            ? tr("Loading the lessons …")
                     : entry == nullptr ? tr("No matching lessons")
                                        : nameOf(*entry));
    m_goal->setText(isEmpty      ? QString()
                    : isSound    ? text::said(entry->read.lesson->goal)
                    : entry      ? tr("This file is not a valid lesson. The other lessons work.")
                    : isSearched ? tr("Search for another word, or show all lessons.")
                                 : tr("There are no such lessons now. Show all lessons."));
    const QList<Fact> facts = entry != nullptr ? factsOf(*entry) : QList<Fact>();
    for (int row = 0; row < facts.size(); ++row) {
        const auto& [name, value] = facts[row];
        grid->addWidget(label(name, kBody, QFont::Normal, QPalette::PlaceholderText, m_facts), row, 0, Qt::AlignTop);
        auto* words = label(value, kBody, QFont::Normal, QPalette::WindowText, m_facts);
        words->setMaximumWidth(kDetailsWidthPx - kFactWidthPx);
        grid->addWidget(words, row, 1);
    }
}

/// Returns the classes that a lesson is assigned to, with due dates and the number of attempts left.
/// @param done  null if the student has not tried the lesson
QString LessonsPage::assignedWords(const Given& given, const Standing* done)
{
    const QDateTime now = QDateTime::currentDateTime();
    const bool isPassed = done != nullptr && done->passed;
    const auto whatOf = [&](const QString& className, const QDateTime& due) {
        QStringList what{className};
        if (due.isValid())
            what << (isPassed ? text::dueDayWords(due, now) : text::dueWords(due, now));
        return what.join(QStringLiteral(", "));
    };
    const QString left = given.attemptsLeft ? tr("%n attempt(s) left", nullptr, *given.attemptsLeft) : QString();
    QStringList what;
    if (given.classes.size() > 1) {  // each class has its own due date
        for (const auto& [className, due] : given.classes)
            what << whatOf(className, due);
        what << left;
    } else {
        what << whatOf(given.className, given.due) + (left.isEmpty() ? QString() : QStringLiteral(", ") + left);
    }
    what.removeAll({});
    return what.join(u'\n');
}

/// Returns the facts about a lesson, line by line, and the errors in its file.
QList<LessonsPage::Fact> LessonsPage::factsOf(const CatalogEntry& entry) const
{
    QList<Fact> facts;
    const auto fact = [&](const QString& name, const QString& value) { facts.push_back({name, value}); };
    if (entry.read.lesson) {
        const ::lessons::Lesson& lesson = *entry.read.lesson;
        if (const Given* const given = givenOf(entry))
            fact(tr("Assigned to"), assignedWords(*given, standingOf(entry)));
        const QString lying = text::lyingWords(lesson);
        fact(tr("Tooth"),
             lying.isEmpty() ? text::toothWords(lesson) : text::toothWords(lesson) + QStringLiteral(", ") + lying);
        fact(tr("Kind"), lesson.exam ? tr("Exam: mistakes are recorded and reported at the end; undo is disabled")
                                     : tr("Practice: mistakes are reported at once"));
        fact(tr("Time"), text::timeWords(lesson));
        fact(tr("Burs"), text::burWords(lesson));
        fact(tr("Aids"), text::aidWords(lesson.aids));
        //: %1 is the name of a rubric, %2 the mark that is needed
        fact(tr("Rubric"),
             tr("%1, passed from %2").arg(text::said(lesson.rubric.title), text::points(lesson.rubric.passMarkTenths)) +
                 u'\n' + text::criteriaWords(lesson.rubric).join(u'\n'));
        if (!lesson.notModelled.empty())
            fact(tr("Not modelled"), text::said(lesson.notModelled));
        const auto standing = m_standings.find(lesson.id);
        fact(tr("Your best"), standing == m_standings.end()
                                  ? tr("no score yet")
                                  : tr("%1 in %n attempt(s)", nullptr, standing->second.attempts)
                                        .arg(text::points(standing->second.bestTenths)));
    }
    for (const ::lessons::ValidationIssue& fault : entry.read.faults)
        fact(fault.grave ? tr("Error") : tr("Note"), text::faultWords(fault));
    return facts;
}

void LessonsPage::start()
{
    if (const CatalogEntry* entry = chosen(); entry != nullptr && entry->read.lesson && !isUsedUp(*entry))
        choose(*entry->read.lesson);
}

void LessonsPage::showEvent(QShowEvent* event)
{
    Page::showEvent(event);
    m_list->setFocus();
}

/// Moves by a page: to the lowest (or highest) card within a page's height, and of these to the nearest one to the
/// side. Qt's own search fails among cards with headings that span whole rows.
void LessonsPage::turnPage(bool down)
{
    const QRect from = m_list->visualRect(m_list->currentIndex());
    QModelIndex best;
    std::pair<int, int> bestPlace{0, 0};
    for (int row = 0; row < m_model->rowCount(); ++row) {
        const QModelIndex index = m_model->index(row, 0);
        const QRect place = m_list->visualRect(index);
        const int along = down ? place.top() - from.top() : from.top() - place.top();
        if (!index.data(CardEntry).isValid() || along <= 0 || along > m_list->viewport()->height())
            continue;
        const std::pair worth(along, -std::abs(place.left() - from.left()));
        if (!best.isValid() || worth > bestPlace) {
            best = index;
            bestPlace = worth;
        }
    }
    if (best.isValid()) {
        m_list->setCurrentIndex(best);
        m_list->scrollTo(best);
    }
}

/// Moves the focus from the search field to the list by arrow keys, and back when the user types.
bool LessonsPage::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_list && (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress)) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool isWord = !key->text().isEmpty() && key->text().front().isPrint() && key->key() != Qt::Key_Space &&
                            (key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
        if (isWord && event->type() == QEvent::ShortcutOverride) {
            event->accept();
            return true;
        }
        if (isWord) {
            m_search->setFocus();
            m_search->selectAll();
            QCoreApplication::sendEvent(m_search, event);
            return true;
        }
    }
    if (watched == m_list && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_PageDown || key == Qt::Key_PageUp) {
            turnPage(key == Qt::Key_PageDown);
            return true;
        }
    }
    if (watched == m_search && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Down || key->key() == Qt::Key_Up) {
            m_list->setFocus();
            return true;
        }
        if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
            start();
            return true;
        }
    }
    return Page::eventFilter(watched, event);
}

}  // namespace ui::catalog
