// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/LessonsPage.h"

#include <algorithm>
#include <utility>

#include <QCoreApplication>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPainter>
#include <QPushButton>
#include <QStandardItemModel>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "ui/shell/Actions.h"
#include "ui/shell/LineIcon.h"
#include "ui/shell/ScrollPane.h"
#include "ui/shell/Theme.h"
#include "ui/study/LessonPicture.h"
#include "ui/study/LessonWords.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::study {
namespace {

using namespace ui::shell;
using ::lessons::CatalogEntry;

constexpr int kListWidthPx = 420;
constexpr int kDetailsWidthPx = 560;
constexpr int kFactWidthPx = 120;
constexpr int kRowPx = 52;
constexpr int kHeadPx = 40;

enum Role { kEntry = Qt::UserRole + 1, kSecondLine, kStanding, kPassed, kMarked };

/// A heading, or a lesson in two lines with the best score at its right.
class Rows final : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const override
    {
        return {200, index.data(kEntry).isValid() ? kRowPx : kHeadPx};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        painter->save();
        const QPalette& p = option.palette;
        const QRect room = option.rect.adjusted(kSpace4, 0, -kSpace4, 0);
        const QString words = index.data(Qt::DisplayRole).toString();
        if (!index.data(kEntry).isValid()) {
            painter->setFont(typeface(kSmall, QFont::DemiBold));
            painter->setPen(p.color(QPalette::PlaceholderText));
            painter->drawText(room.adjusted(0, 0, 0, -kSpace1), Qt::AlignLeft | Qt::AlignBottom, words);
            painter->restore();
            return;
        }
        const bool isSelected = option.state.testFlag(QStyle::State_Selected);
        const bool isOver = option.state.testFlag(QStyle::State_MouseOver);
        if (isSelected || isOver) {
            painter->setRenderHint(QPainter::Antialiasing);
            painter->setPen(isSelected ? QPen(p.color(QPalette::Link), 1.5) : QPen(Qt::NoPen));
            painter->setBrush(p.color(QPalette::Midlight));
            painter->drawRoundedRect(QRectF(option.rect).adjusted(2, 2, -2, -2), 6, 6);
        }
        const QString standing = index.data(kStanding).toString();
        const int scoreWidth = standing.isEmpty() ? 0 : 72;
        const QRect left = room.adjusted(0, 7, -scoreWidth, -7);
        painter->setFont(typeface(kBody, index.data(kMarked).toBool() ? QFont::DemiBold : QFont::Medium));
        painter->setPen(p.color(QPalette::WindowText));
        painter->drawText(left, Qt::AlignLeft | Qt::AlignTop,
                          painter->fontMetrics().elidedText(words, Qt::ElideRight, left.width()));
        painter->setFont(typeface(kSmall));
        painter->setPen(p.color(QPalette::PlaceholderText));
        painter->drawText(
            left, Qt::AlignLeft | Qt::AlignBottom,
            painter->fontMetrics().elidedText(index.data(kSecondLine).toString(), Qt::ElideRight, left.width()));
        if (!standing.isEmpty()) {
            const Tones tone = tones(p);
            painter->setFont(typeface(kBody, QFont::DemiBold));
            painter->setPen(index.data(kPassed).toBool() ? p.color(QPalette::Link) : tone.attentionText);
            painter->drawText(room, Qt::AlignRight | Qt::AlignVCenter, standing);
        }
        painter->restore();
    }
};

QLabel* label(const QString& words, int size, QFont::Weight weight, QPalette::ColorRole role, QWidget* parent)
{
    auto* made = new QLabel(words, parent);
    made->setTextFormat(Qt::PlainText);  // a teacher's words, whatever they look like
    made->setFont(typeface(size, weight));
    made->setForegroundRole(role);
    made->setWordWrap(true);
    return made;
}

}  // namespace

LessonsPage::LessonsPage(const Actions& actions, QWidget* parent) : Page(actions, parent)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace6);
    row->addWidget(makeList(), 2);
    row->addWidget(makeDetails(actions), 3);
    body()->addLayout(row, 1);
    text::inEveryLanguage(this, [this] {
        setTitle(tr("Lessons"));
        fillList();
    });
}

QWidget* LessonsPage::makeList()
{
    auto* side = new QWidget(this);
    side->setMaximumWidth(kListWidthPx);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(kSpace4, 0, 0, 0);
    column->setSpacing(kSpace2);
    m_search = new QLineEdit(side);
    text::inEveryLanguage(m_search, [this] {
        m_search->setPlaceholderText(tr("Search: a word, or the number of a tooth"));
        m_search->setAccessibleName(tr("Search the lessons"));
    });
    m_search->setClearButtonEnabled(true);
    for (auto* clear : m_search->findChildren<QAbstractButton*>())
        text::inEveryLanguage(clear, [clear] { clear->setAccessibleName(tr("Clear the search")); });
    m_search->setFont(typeface(kBody));
    m_search->installEventFilter(this);
    column->addWidget(m_search);
    m_model = new QStandardItemModel(side);
    m_list = new QListView(side);
    m_list->setModel(m_model);
    m_list->setItemDelegate(new Rows(m_list));
    text::inEveryLanguage(m_list, [this] { m_list->setAccessibleName(tr("Lessons")); });
    m_list->setMouseTracking(true);
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setProperty("kind", "plain");
    m_list->setObjectName(QStringLiteral("lessonList"));
    column->addWidget(m_list, 1);
    connect(m_search, &QLineEdit::textChanged, this, &LessonsPage::search);
    m_list->installEventFilter(this);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, &LessonsPage::describe);
    connect(m_list, &QListView::activated, this, &LessonsPage::start);
    // A click beside the rows chooses nothing else.
    connect(m_list->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        if (m_list->currentIndex().isValid() && !m_list->selectionModel()->hasSelection())
            m_list->selectionModel()->select(m_list->currentIndex(), QItemSelectionModel::Select);
    });
    return side;
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
    auto* stack = new QVBoxLayout(whole);
    stack->setContentsMargins(0, 0, 0, 0);
    stack->addWidget(scroll, 1);
    auto* buttons = new QHBoxLayout;
    m_start = new QPushButton(whole);
    text::inEveryLanguage(m_start, [this] { m_start->setText(tr("Start")); });
    m_start->setProperty("kind", "filled");
    text::inEveryLanguage(m_start, [this] {
        m_start->setAccessibleName(tr("Start this lesson"));
        m_start->setToolTip(tr("Put the tooth of this lesson on the table (Enter)"));
    });
    m_start->setObjectName(QStringLiteral("startLesson"));
    m_start->setAutoDefault(true);
    connect(m_start, &QPushButton::clicked, this, &LessonsPage::start);
    auto* folder = new QPushButton(whole);
    text::inEveryLanguage(folder, [folder] {
        folder->setText(tr("Your own lessons …"));
        folder->setToolTip(tr("Open the folder that a teacher's lessons are read from"));
        folder->setAccessibleName(tr("Open the folder of your own lessons"));
    });
    folder->setAutoDefault(false);
    connect(folder, &QPushButton::clicked, this, &LessonsPage::folderWanted);
    buttons->addWidget(m_start);
    m_edit = pageButton(actions.editLesson, "", whole);
    buttons->addWidget(m_edit);
    buttons->addWidget(folder);
    buttons->addStretch(1);
    stack->addLayout(buttons);
    return whole;
}

void LessonsPage::setLessons(std::vector<CatalogEntry> entries, std::map<std::string, Standing> standings)
{
    m_entries = std::move(entries);
    m_standings = std::move(standings);
    // Faulty ones last; of one kind in the order of their files.
    std::stable_sort(m_entries.begin(), m_entries.end(), [](const CatalogEntry& a, const CatalogEntry& b) {
        const auto place = [](const CatalogEntry& entry) {
            return entry.isFaulty() ? 100 : groupPlace(entry.read.lesson->task);
        };
        return place(a) < place(b);
    });
    fillList();
}

void LessonsPage::setPresent(const std::string& lessonId)
{
    m_present = lessonId;
    fillList();
}

void LessonsPage::setUnsaved(const QSet<QString>& files)
{
    if (std::exchange(m_unsaved, files) != files)
        fillList();
}

void LessonsPage::fillList()
{
    const CatalogEntry* before = chosen();
    const std::string kept = before != nullptr && before->read.lesson ? before->read.lesson->id : m_present;
    const QStringList words = m_search->text().split(u' ', Qt::SkipEmptyParts);
    m_model->clear();
    QString group;
    QModelIndex select;
    for (std::size_t k = 0; k < m_entries.size(); ++k) {
        const CatalogEntry& entry = m_entries[k];
        const auto& lesson = entry.read.lesson;
        const QString title = lesson ? said(lesson->title) : QFileInfo(entry.read.file).fileName();
        QStringList notes{lesson ? toothWords(*lesson) : tr("Cannot be given")};
        if (lesson && lesson->exam)
            notes << tr("exam");
        if (m_unsaved.contains(entry.read.file))
            //: Of a lesson in a list: in the editor
            notes << tr("changed, not saved");
        const QString second = notes.join(QStringLiteral(" · "));
        const QString all = title + u' ' + second + u' ' + (lesson ? QString::fromStdString(lesson->id) : QString());
        if (!std::all_of(words.begin(), words.end(),
                         [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); }))
            continue;
        const QString heading = lesson ? groupName(lesson->task) : tr("Cannot be given");
        if (heading != group) {
            auto* head = new QStandardItem(heading);
            head->setFlags(Qt::NoItemFlags);
            m_model->appendRow(head);
            group = heading;
        }
        auto* item = new QStandardItem(title);
        item->setData(static_cast<int>(k), kEntry);
        item->setData(second, kSecondLine);
        item->setData(second, Qt::AccessibleDescriptionRole);
        if (lesson) {
            if (const auto standing = m_standings.find(lesson->id); standing != m_standings.end()) {
                const QString points = text::points(standing->second.bestTenths);
                const bool passed = standing->second.passed;
                item->setData(passed ? QStringLiteral("✓ ") + points : points, kStanding);
                item->setData(passed, kPassed);
                //: For a screen reader: the best score of a lesson
                item->setData(second + QStringLiteral(", ") +
                                  (passed ? tr("best %1, passed") : tr("best %1, not passed")).arg(points),
                              Qt::AccessibleDescriptionRole);
            }
            item->setData(lesson->id == m_present, kMarked);
        }
        m_model->appendRow(item);
        if (!select.isValid() || (lesson && lesson->id == kept))
            select = item->index();
    }
    m_list->setCurrentIndex(select);
    m_list->scrollTo(select);
    describe();
}

/// The first that fits is chosen, so that Enter starts it.
void LessonsPage::search()
{
    fillList();
    if (m_search->text().trimmed().isEmpty())
        return;
    m_list->setCurrentIndex(m_model->index(std::min(1, m_model->rowCount() - 1), 0));  // beneath its heading
    m_list->scrollToTop();
}

const CatalogEntry* LessonsPage::chosen() const
{
    const QVariant entry = m_list->currentIndex().data(kEntry);
    return entry.isValid() ? &m_entries[static_cast<std::size_t>(entry.toInt())] : nullptr;
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
    grid->setColumnStretch(2, 1);
    m_factsSlot->addWidget(m_facts);
    const CatalogEntry* entry = chosen();
    const bool isSound = entry != nullptr && entry->read.lesson.has_value();
    m_start->setEnabled(isSound);
    m_picture->setLesson(isSound ? entry->read.lesson : std::nullopt);
    m_edit->setVisible(isSound);
    m_title->setText(entry == nullptr ? tr("No lesson fits the search")
                     : isSound        ? said(entry->read.lesson->title)
                                      : QFileInfo(entry->read.file).fileName());
    m_goal->setText(isSound ? said(entry->read.lesson->goal)
                    : entry ? tr("This file cannot be given as a lesson. The others work.")
                            : tr("Search for another word, or clear the field."));
    int row = 0;
    const auto fact = [&](const QString& name, const QString& value) {
        grid->addWidget(label(name, kBody, QFont::Normal, QPalette::PlaceholderText, m_facts), row, 0, Qt::AlignTop);
        auto* words = label(value, kBody, QFont::Normal, QPalette::WindowText, m_facts);
        words->setFixedWidth(kDetailsWidthPx - kFactWidthPx);
        grid->addWidget(words, row++, 1);
    };
    if (isSound) {
        const ::lessons::Lesson& lesson = *entry->read.lesson;
        fact(tr("Tooth"), toothWords(lesson));
        fact(tr("Kind"), lesson.exam
                             ? tr("Exam: faults are noted, nothing is said until the end, and no step is taken back")
                             : tr("Practice: you are told what goes wrong"));
        fact(tr("Time"), timeWords(lesson));
        fact(tr("Burs"), burWords(lesson));
        fact(tr("Aids"), aidWords(lesson.aids));
        //: %1 is the name of a rubric, %2 the mark that is needed
        fact(tr("Marked by"),
             tr("%1, passed from %2").arg(said(lesson.rubric.title), text::points(lesson.rubric.passMarkTenths)) +
                 u'\n' + criteriaWords(lesson.rubric).join(u'\n'));
        if (!lesson.notModelled.empty())
            fact(tr("Not modelled"), said(lesson.notModelled));
        const auto standing = m_standings.find(lesson.id);
        fact(tr("Your best"), standing == m_standings.end()
                                  ? tr("not tried yet")
                                  : tr("%1 in %n attempt(s)", nullptr, standing->second.attempts)
                                        .arg(text::points(standing->second.bestTenths)));
    }
    if (entry != nullptr)
        for (const ::lessons::Fault& fault : entry->read.faults)
            fact(fault.grave ? tr("Wrong") : tr("Note"), fault.sentence());
}

void LessonsPage::start()
{
    if (const CatalogEntry* entry = chosen(); entry != nullptr && entry->read.lesson)
        emit lessonChosen(*entry->read.lesson);
}

void LessonsPage::showEvent(QShowEvent* event)
{
    Page::showEvent(event);
    m_list->setFocus();
}

/// From the search one goes on in the list without the mouse, and back by typing.
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

}  // namespace ui::study
