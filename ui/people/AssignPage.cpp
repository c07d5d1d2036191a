// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/AssignPage.h"

#include <algorithm>
#include <set>
#include <utility>

#include <QAbstractButton>
#include <QFrame>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QShortcut>
#include <QStackedWidget>
#include <QStandardItemModel>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "ui/kit/Accessibility.h"
#include "ui/kit/ListTable.h"
#include "ui/kit/Theme.h"
#include "ui/people/ClassModel.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/PeopleTexts.h"
#include "ui/text/Search.h"

namespace ui::people {
namespace {

using namespace ui::kit;

enum Role { kId = Qt::UserRole + 1, kSecondLine, kShare, kSortBy };
enum Column { kLesson, kDue, kAttempts, kPassed, kColumns };

constexpr int kRowPx = 44;
constexpr int kHeadingPx = 30;
constexpr int kBoxPx = 16;
constexpr int kBarPx = 4;

/// Paints a row of the offers: a lesson with a check box, or the heading of a group.
class OfferRow final : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const override
    {
        return {200, index.data(kId).isValid() ? kRowPx : kHeadingPx};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        painter->save();
        const QPalette& p = option.palette;
        const QRect room = option.rect.adjusted(kSpace2, 0, -kSpace2, 0);
        const QString words = index.data().toString();
        const auto draw = [&](const QRect& where, int flags, const QString& what) {
            painter->drawText(where, flags, painter->fontMetrics().elidedText(what, Qt::ElideRight, where.width()));
        };
        if (!index.data(kId).isValid()) {
            painter->setFont(typeface(kSmall, QFont::DemiBold));
            painter->setPen(p.color(QPalette::PlaceholderText));
            draw(room.adjusted(0, 0, 0, -kSpace1), Qt::AlignLeft | Qt::AlignBottom, words);
            painter->restore();
            return;
        }
        painter->setRenderHint(QPainter::Antialiasing);
        const bool isOver = option.state.testFlag(QStyle::State_MouseOver);
        const bool isCurrent = option.state.testFlag(QStyle::State_HasFocus);
        if (isOver || isCurrent) {
            painter->setPen(isCurrent ? QPen(p.color(QPalette::Link), 1.5) : QPen(Qt::NoPen));
            painter->setBrush(p.color(QPalette::Midlight));
            painter->drawRoundedRect(QRectF(option.rect).adjusted(1, 1, -1, -1), kRadius, kRadius);
        }
        const bool isGiven = !index.flags().testFlag(Qt::ItemIsUserCheckable);
        if (!isGiven)
            paintBox(*painter, p, room, index.data(Qt::CheckStateRole).toInt() == Qt::Checked);
        const QRect text = room.adjusted(kBoxPx + kSpace2, 4, 0, -4);
        painter->setFont(typeface(kBody));
        painter->setPen(p.color(isGiven ? QPalette::PlaceholderText : QPalette::WindowText));
        draw(text, Qt::AlignLeft | Qt::AlignTop, words);
        painter->setFont(typeface(kSmall));
        painter->setPen(p.color(QPalette::PlaceholderText));
        draw(text, Qt::AlignLeft | Qt::AlignBottom, index.data(kSecondLine).toString());
        painter->restore();
    }

    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem&,
                     const QModelIndex& index) override
    {
        const bool isPressed =
            event->type() == QEvent::MouseButtonRelease ||
            (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space);
        if (!isPressed || !index.flags().testFlag(Qt::ItemIsUserCheckable))
            return false;
        const bool isTicked = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
        return model->setData(index, isTicked ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
    }

private:
    static void paintBox(QPainter& painter, const QPalette& p, const QRect& room, bool isTicked)
    {
        const QRectF box(room.left() + 0.5, room.center().y() - 0.5 * kBoxPx + 0.5, kBoxPx, kBoxPx);
        painter.setPen(QPen(p.color(isTicked ? QPalette::Highlight : QPalette::PlaceholderText), 1.0));
        painter.setBrush(isTicked ? QBrush(p.color(QPalette::Highlight)) : QBrush(Qt::NoBrush));
        painter.drawRoundedRect(box, 4.0, 4.0);
        if (!isTicked)
            return;
        const QPointF middle = box.center();
        painter.setPen(QPen(p.color(QPalette::HighlightedText), 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolyline(QPolygonF{
            {middle.x() - 4.0, middle.y()}, {middle.x() - 1.0, middle.y() + 3.0}, middle + QPointF(4.5, -3.5)});
    }
};

/// A list in which the space bar always ticks a row.
class OfferList final : public QListView
{
public:
    using QListView::QListView;

protected:
    bool event(QEvent* event) override
    {
        if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) {
            event->accept();
            return true;
        }
        return QListView::event(event);
    }
};

/// Paints "7 of 12" with a bar of that proportion below it.
class PassedCell final : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::paint(painter, option, index);
        const QPalette& p = option.palette;
        const bool isSelected = option.state.testFlag(QStyle::State_Selected);
        const QRectF bar(option.rect.left() + kSpace2, option.rect.bottom() - kBarPx - 2,
                         option.rect.width() - 2 * kSpace2, kBarPx);
        const double share = index.data(kShare).toDouble();
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(Qt::NoPen);
        painter->setBrush(p.color(QPalette::Mid));
        painter->drawRoundedRect(bar, 2.0, 2.0);
        painter->setBrush(isSelected ? p.color(QPalette::HighlightedText) : tones(p).accent);
        if (share > 0.0)
            painter->drawRoundedRect(QRectF(bar.topLeft(), QSizeF(share * bar.width(), bar.height())), 2.0, 2.0);
        painter->restore();
    }
};

QLabel* title(QWidget* parent)
{
    auto* made = new QLabel(parent);
    made->setTextFormat(Qt::PlainText);
    made->setFont(typeface(kBody, QFont::DemiBold));
    made->setWordWrap(true);
    return made;
}

QFrame* card(QWidget* parent)
{
    auto* frame = new QFrame(parent);
    frame->setProperty("kind", "card");
    auto* column = new QVBoxLayout(frame);
    column->setContentsMargins(kSpace4, kSpace2, kSpace4, kSpace4);
    column->setSpacing(kSpace2);
    return frame;
}

}  // namespace

AssignPage::AssignPage(const Actions& actions, QWidget* parent) : Page(actions, parent)
{
    body()->setSpacing(kSpace2);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(kSpace2, 0, kSpace2, 0);
    row->setSpacing(kSpace4);
    row->addWidget(makeOffers(), 2);
    row->addWidget(makeGiven(), 3);
    body()->addLayout(row, 1);
    body()->addWidget(makeFeet());
    text::bindTranslation(this, [this] { retell(); });
}

QWidget* AssignPage::makeOffers()
{
    QFrame* part = card(this);
    auto* column = static_cast<QVBoxLayout*>(part->layout());
    m_offersTitle = title(part);
    column->addWidget(m_offersTitle);
    m_search = new QLineEdit(part);
    m_search->setObjectName(QStringLiteral("offerSearch"));
    m_search->setClearButtonEnabled(true);
    m_search->setFont(typeface(kBody));
    connect(m_search, &QLineEdit::textChanged, this, &AssignPage::search);
    column->addWidget(m_search);
    m_offers = new QStandardItemModel(part);
    m_list = new OfferList(part);
    m_list->setObjectName(QStringLiteral("offers"));
    m_list->setModel(m_offers);
    m_list->setItemDelegate(new OfferRow(m_list));
    m_list->setMouseTracking(true);
    m_list->setSelectionMode(QAbstractItemView::NoSelection);
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setProperty("kind", "plain");
    connect(m_offers, &QStandardItemModel::itemChanged, this, &AssignPage::updateChosen);
    column->addWidget(m_list, 1);
    m_noneFits = new QLabel(part);
    m_noneFits->setObjectName(QStringLiteral("noneFits"));
    m_noneFits->setTextFormat(Qt::PlainText);
    m_noneFits->setForegroundRole(QPalette::PlaceholderText);
    m_noneFits->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_noneFits->setWordWrap(true);
    m_noneFits->hide();
    column->addWidget(m_noneFits, 1);
    column->addWidget(line(part));
    m_newTerms = new AssignTerms(part);
    column->addWidget(m_newTerms);
    m_assign = new QPushButton(part);
    m_assign->setObjectName(QStringLiteral("assignTicked"));
    m_assign->setProperty("kind", "filled");
    m_assign->setAutoDefault(true);
    connect(m_assign, &QPushButton::clicked, this, [this] {
        const AssignTerms::Terms terms = m_newTerms->terms();
        QList<AssignmentChange> changes;
        for (const LessonOffer& lesson : ticked())
            changes << AssignmentChange{{},
                                        database::ClassAssignment{0, m_overview.id, lesson.id, terms.dueUtc,
                                                                  terms.attemptLimit, lesson.hash, lesson.version}};
        take(changes);
    });
    column->addWidget(m_assign);
    return part;
}

QWidget* AssignPage::makeGiven()
{
    QFrame* part = card(this);
    auto* column = static_cast<QVBoxLayout*>(part->layout());
    m_givenTitle = title(part);
    m_givenTitle->setObjectName(QStringLiteral("givenTitle"));
    column->addWidget(m_givenTitle);
    m_stack = new QStackedWidget(part);
    m_rows = new QStandardItemModel(0, kColumns, part);
    m_rows->setSortRole(kSortBy);
    m_table = new kit::ListTable(m_stack);
    m_table->setObjectName(QStringLiteral("given"));
    m_table->setModel(m_rows);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setItemDelegateForColumn(kPassed, new PassedCell(m_table));
    m_table->sortByColumn(kDue, Qt::AscendingOrder);
    m_table->verticalHeader()->hide();
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    QHeaderView* heads = m_table->horizontalHeader();
    heads->setSectionResizeMode(QHeaderView::ResizeToContents);
    heads->setSectionResizeMode(kLesson, QHeaderView::Stretch);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        if (const auto rows = chosen(); !rows.isEmpty())
            m_terms->setTerms({rows.front().dueUtc, rows.front().attemptLimit}, static_cast<int>(rows.size()));
        updateChosen();
    });
    m_stack->addWidget(m_table);
    m_empty = new QLabel(m_stack);
    m_empty->setObjectName(QStringLiteral("nothingGiven"));
    m_empty->setTextFormat(Qt::PlainText);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_stack->addWidget(m_empty);
    column->addWidget(m_stack, 1);
    column->addWidget(line(part));
    auto* feet = new QHBoxLayout;
    feet->setSpacing(kSpace4);
    m_terms = new AssignTerms(part);
    feet->addWidget(m_terms, 1);
    auto* buttons = new QVBoxLayout;
    buttons->setSpacing(kSpace1);
    m_change = new QPushButton(part);
    m_change->setObjectName(QStringLiteral("changeGiven"));
    m_takeBack = new QPushButton(part);
    m_takeBack->setObjectName(QStringLiteral("takeBack"));
    m_update = new QPushButton(part);
    m_update->setObjectName(QStringLiteral("assignLater"));
    for (QPushButton* button : {m_change, m_update, m_takeBack}) {
        button->setAutoDefault(true);
        buttons->addWidget(button);
    }
    feet->addLayout(buttons);
    column->addLayout(feet);
    connectGiven();
    return part;
}

void AssignPage::connectGiven()
{
    connect(m_change, &QPushButton::clicked, this, [this] {
        QList<AssignmentChange> changes;
        for (const database::ClassAssignment& given : chosen()) {
            const AssignTerms::Terms before{given.dueUtc, given.attemptLimit};
            if (const AssignTerms::Terms terms = m_terms->changed(before); terms != before) {
                database::ClassAssignment after = given;
                after.dueUtc = terms.dueUtc;
                after.attemptLimit = terms.attemptLimit;
                changes << AssignmentChange{given, after};
            }
        }
        take(changes);
    });
    connect(m_update, &QPushButton::clicked, this, [this] {
        QList<AssignmentChange> changes;
        for (const database::ClassAssignment& given : chosen())
            if (const LessonOffer* later = laterVersionOf(given)) {
                database::ClassAssignment after = given;
                after.lessonHash = later->hash;
                after.lessonVersion = later->version;
                changes << AssignmentChange{given, after};
            }
        take(changes);
    });
    connect(m_takeBack, &QPushButton::clicked, this, [this] {
        QList<AssignmentChange> changes;
        for (const database::ClassAssignment& given : chosen())
            changes << AssignmentChange{given, {}};
        take(changes);
    });
}

/// Makes the bottom row: the last change, and the button that undoes it.
QWidget* AssignPage::makeFeet()
{
    auto* part = new QWidget(this);
    auto* row = new QHBoxLayout(part);
    row->setContentsMargins(kSpace4, 0, kSpace4, 0);
    row->setSpacing(kSpace4);
    m_said = new QLabel(part);
    m_said->setObjectName(QStringLiteral("assignSaid"));
    m_said->setTextFormat(Qt::PlainText);
    m_said->setWordWrap(true);
    m_undo = new QPushButton(part);
    m_undo->setObjectName(QStringLiteral("undoAssign"));
    m_undo->setAutoDefault(true);
    m_undo->hide();
    connect(m_undo, &QPushButton::clicked, this, [this] {
        QList<AssignmentChange> back;
        for (const AssignmentChange& change : m_last)
            back << AssignmentChange{change.after, change.before};
        m_isUndoing = true;
        take(back);
    });
    auto* undo = new QShortcut(QKeySequence::Undo, this);
    undo->setContext(Qt::WidgetWithChildrenShortcut);
    connect(undo, &QShortcut::activated, this, [this] {
        if (m_undo->isVisible())
            m_undo->click();
    });
    row->addWidget(m_said, 1);
    row->addWidget(m_undo);
    part->setMinimumHeight(m_undo->sizeHint().height());
    return part;
}

void AssignPage::setLessons(const std::vector<LessonOffer>& lessons)
{
    m_lessons = lessons;
    fillOffers();
    fillGiven();
}

void AssignPage::setAssignments(const database::ClassOverview& overview, const QList<database::ClassAssignment>& given,
                                const QDateTime& now)
{
    const bool isAnother = overview.id != m_overview.id;
    m_overview = overview;
    m_now = now;
    m_given.clear();
    for (const database::ClassAssignment& one : given)
        if (one.classId == overview.id)
            m_given << one;
    if (isAnother)
        beginAfresh();
    retell();
}

void AssignPage::beginAfresh()
{
    m_last.clear();
    m_undo->hide();
    m_saying = {};
    m_said->clear();
    m_offers->clear();
    m_search->clear();
}

void AssignPage::forget()
{
    beginAfresh();
    m_overview = {};
    m_given.clear();
    // Discards a pending request. Its answer is for the user who sent it, who has logged out.
    m_isAsking = false;
    m_isUndoing = false;
    m_hadFocus = false;
    m_newTerms->reset();
    retell();
}

QString AssignPage::titleOf(const std::string& lessonId) const
{
    const auto found = std::find_if(m_lessons.begin(), m_lessons.end(),
                                    [&](const LessonOffer& lesson) { return lesson.id == lessonId; });
    return found == m_lessons.end() ? QString::fromStdString(lessonId) : found->title;
}

/// Returns the version of this computer, if it is not the assigned one and has no lower number. Null otherwise.
const LessonOffer* AssignPage::laterVersionOf(const database::ClassAssignment& given) const
{
    const auto offer = std::find_if(m_lessons.begin(), m_lessons.end(),
                                    [&](const LessonOffer& one) { return one.id == given.lessonId; });
    const bool isLater =
        offer != m_lessons.end() && offer->hash != given.lessonHash && offer->version >= given.lessonVersion;
    return isLater ? &*offer : nullptr;
}

/// Returns the students with no attempt left under these terms. Attempts before the assignment count.
std::set<std::size_t> AssignPage::usedUp(const database::ClassAssignment& given) const
{
    std::set<std::size_t> students;
    const auto place = std::find(m_overview.lessons.begin(), m_overview.lessons.end(), given.lessonId);
    if (place == m_overview.lessons.end())
        return students;
    const auto column = static_cast<std::size_t>(place - m_overview.lessons.begin());
    const QDateTime now = QDateTime::currentDateTimeUtc();
    for (std::size_t row = 0; row < m_overview.cells.size(); ++row) {
        const database::MatrixCell& cell = m_overview.cells[row][column];
        if (cell.isUsedUp(given.attemptLimit) && !mayGoOn(cell, now) && !m_overview.students[row].isDisabled)
            students.insert(row);
    }
    return students;
}

/// Fills the list of lessons to assign. Keeps ticks, except of lessons that have been assigned meanwhile.
void AssignPage::fillOffers()
{
    std::set<std::string> kept;
    for (const LessonOffer& lesson : ticked())
        kept.insert(lesson.id);
    const QString currentId = m_list->currentIndex().data(kId).toString();
    m_offers->clear();
    QString group;
    QModelIndex again;
    for (const LessonOffer& lesson : m_lessons) {
        if (lesson.group != group) {
            group = lesson.group;
            auto* heading = new QStandardItem(group);
            heading->setFlags(Qt::NoItemFlags);
            m_offers->appendRow(heading);
        }
        const auto given = std::find_if(m_given.begin(), m_given.end(), [&](const database::ClassAssignment& one) {
            return one.lessonId == lesson.id;
        });
        auto* item = new QStandardItem(lesson.title);
        item->setData(QString::fromStdString(lesson.id), kId);
        if (given == m_given.end()) {
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
            item->setCheckState(kept.count(lesson.id) > 0 ? Qt::Checked : Qt::Unchecked);
            item->setData(lesson.tooth, kSecondLine);
        } else {
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
            item->setData(given->dueUtc.empty() ? tr("given")
                                                //: %1: a date
                                                : tr("given, due %1").arg(text::dueShort(given->dueUtc, m_now)),
                          kSecondLine);
        }
        item->setData(item->data(kSecondLine), Qt::AccessibleDescriptionRole);
        item->setToolTip(lesson.title);
        m_offers->appendRow(item);
        if (item->data(kId).toString() == currentId)
            again = item->index();
    }
    search();
    if (again.isValid())
        m_list->setCurrentIndex(again);
    updateChosen();
}

/// Shows the lessons whose titles contain every word, and the headings of their groups.
void AssignPage::search()
{
    int heading = -1;
    bool isAny = m_offers->rowCount() == 0;
    const auto matches = [&](const QStandardItem& item) {
        const QString id = item.data(kId).toString();
        const auto lesson = std::find_if(m_lessons.begin(), m_lessons.end(),
                                         [&](const LessonOffer& one) { return QString::fromStdString(one.id) == id; });
        return text::holdsEach(lesson->title + u' ' + lesson->tooth + u' ' + lesson->group + u' ' + id,
                               m_search->text());
    };
    for (int row = 0; row < m_offers->rowCount(); ++row) {
        const QStandardItem* item = m_offers->item(row);
        const bool isHeading = !item->data(kId).isValid();
        const bool isShown = !isHeading && matches(*item);
        m_list->setRowHidden(row, !isShown);
        isAny = isAny || isShown;
        if (isHeading)
            heading = row;
        else if (isShown && heading >= 0)
            m_list->setRowHidden(heading, false);
    }
    m_list->setVisible(isAny);
    m_noneFits->setVisible(!isAny);
    keepCurrentInSight();
}

/// Makes the current row visible. A hidden row could be ticked unseen.
void AssignPage::keepCurrentInSight()
{
    const QModelIndex current = m_list->currentIndex();
    if (current.isValid() && !m_list->isRowHidden(current.row()))
        return;
    QModelIndex first;
    for (int row = 0; row < m_offers->rowCount() && !first.isValid(); ++row)
        if (!m_list->isRowHidden(row) && m_offers->item(row)->isEnabled())
            first = m_offers->index(row, 0);
    m_list->setCurrentIndex(first);
}

void AssignPage::fillGiven()
{
    std::set<std::string> kept;
    for (const database::ClassAssignment& one : chosen())
        kept.insert(one.lessonId);
    m_rows->removeRows(0, m_rows->rowCount());
    const auto students = static_cast<int>(std::count_if(m_overview.students.begin(), m_overview.students.end(),
                                                         [](const auto& one) { return !one.isDisabled; }));
    const std::string nowUtc = m_now.toString(Qt::ISODate).toStdString();
    for (const database::ClassAssignment& given : m_given) {
        const auto place = std::find(m_overview.lessons.begin(), m_overview.lessons.end(), given.lessonId);
        int passed = 0;
        int tried = 0;
        if (place != m_overview.lessons.end())
            for (std::size_t k = 0; k < m_overview.students.size(); ++k) {
                if (m_overview.students[k].isDisabled)
                    continue;
                const database::MatrixCell& cell =
                    m_overview.cells[k][static_cast<std::size_t>(place - m_overview.lessons.begin())];
                passed += cell.passed ? 1 : 0;
                tried += cell.attempts > 0 ? 1 : 0;
            }
        QList<QStandardItem*> row;
        const auto add = [&](const QString& words, const QVariant& sortBy) {
            auto* item = new QStandardItem(words);
            item->setData(QString::fromStdString(given.lessonId), kId);
            item->setData(sortBy, kSortBy);
            row << item;
            return item;
        };
        const QString title = titleOf(given.lessonId);
        const LessonOffer* later = laterVersionOf(given);
        //: %1: title of a lesson
        add(later != nullptr ? tr("%1 (a later version is available)").arg(title) : title, title)
            ->setToolTip(given.lessonVersion == 0 ? title
                                                  //: %1: title of a lesson, %2: number of its version
                                                  : tr("%1, version %2").arg(title).arg(given.lessonVersion));
        const bool isOver = !given.dueUtc.empty() && given.dueUtc < nowUtc;
        const QString due = text::dueShort(given.dueUtc, m_now);
        // Lessons without a due date are sorted last; their sort key is a year later than all others.
        auto* dueItem = add(given.dueUtc.empty() ? QStringLiteral("–")
                            //: %1: a date that is over
                            : isOver ? tr("%1, over").arg(due)
                                     : due,
                            given.dueUtc.empty() ? QStringLiteral("9999") : QString::fromStdString(given.dueUtc));
        dueItem->setToolTip(given.dueUtc.empty() ? tr("There is no day when it is due") : text::when(given.dueUtc));
        add(given.attemptLimit == 0 ? tr("no limit") : QLocale().toString(given.attemptLimit),
            given.attemptLimit == 0 ? 1000 : given.attemptLimit);
        //: %1 of %2 students
        auto* progress = add(tr("%1 of %2").arg(passed).arg(students), passed);
        progress->setData(students == 0 ? 0.0 : static_cast<double>(passed) / students, kShare);
        progress->setToolTip(tr("%1 of %2 have passed, %3 have tried").arg(passed).arg(students).arg(tried));
        m_rows->appendRow(row);
    }
    m_table->sortByColumn(m_table->horizontalHeader()->sortIndicatorSection(),
                          m_table->horizontalHeader()->sortIndicatorOrder());
    for (int row = 0; row < m_rows->rowCount(); ++row)
        if (kept.count(m_rows->item(row)->data(kId).toString().toStdString()) > 0)
            m_table->selectionModel()->select(m_rows->index(row, 0),
                                              QItemSelectionModel::Select | QItemSelectionModel::Rows);
    if (m_given.isEmpty() && m_table->hasFocus())
        m_list->setFocus();
    m_stack->setCurrentIndex(m_given.isEmpty() ? 1 : 0);
    updateChosen();
}

std::vector<LessonOffer> AssignPage::ticked() const
{
    std::vector<LessonOffer> lessons;
    for (int row = 0; row < m_offers->rowCount(); ++row) {
        const QStandardItem* item = m_offers->item(row);
        if (!item->flags().testFlag(Qt::ItemIsUserCheckable) || item->checkState() != Qt::Checked)
            continue;
        const std::string id = item->data(kId).toString().toStdString();
        const auto lesson =
            std::find_if(m_lessons.begin(), m_lessons.end(), [&](const LessonOffer& one) { return one.id == id; });
        if (lesson != m_lessons.end())
            lessons.push_back(*lesson);
    }
    return lessons;
}

QList<database::ClassAssignment> AssignPage::chosen() const
{
    QList<database::ClassAssignment> rows;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows())
        for (const database::ClassAssignment& given : m_given)
            if (QString::fromStdString(given.lessonId) == index.data(kId).toString())
                rows << given;
    return rows;
}

void AssignPage::take(const QList<AssignmentChange>& changes)
{
    if (changes.isEmpty() || m_isAsking) {
        m_isUndoing = m_isUndoing && m_isAsking;
        return;
    }
    m_isAsking = true;
    // The buttons are disabled until the answer arrives, and a disabled button passes its focus to the next widget.
    m_hadFocus = m_assign->hasFocus() || m_change->hasFocus() || m_update->hasFocus() || m_takeBack->hasFocus() ||
                 m_undo->hasFocus();
    if (m_hadFocus)
        (m_given.isEmpty() ? static_cast<QWidget*>(m_list) : m_table)->setFocus();
    updateChosen();
    emit changeRequested(changes);
}

void AssignPage::confirm(const QList<AssignmentChange>& changes)
{
    m_isAsking = false;
    const bool wasUndone = std::exchange(m_isUndoing, false);
    const int count = static_cast<int>(changes.size());
    const auto isAll = [&](auto has) { return std::all_of(changes.begin(), changes.end(), has); };
    m_last = wasUndone ? QList<AssignmentChange>() : changes;
    for (const AssignmentChange& change : changes) {
        const std::string& id = change.after ? change.after->lessonId : change.before->lessonId;
        m_given.removeIf([&id](const database::ClassAssignment& one) { return one.lessonId == id; });
        if (change.after)
            m_given.append(*change.after);
    }
    std::set<std::size_t> stuck;  // students who need help in at least one lesson
    for (const AssignmentChange& change : changes)
        if (change.after)
            stuck.merge(usedUp(*change.after));
    const int noneLeft = static_cast<int>(stuck.size());
    m_saying = [wasUndone, count, noneLeft, isNew = isAll([](const AssignmentChange& one) { return !one.before; }),
                isGone = isAll([](const AssignmentChange& one) { return !one.after; })] {
        QString done = wasUndone ? tr("That was undone.")
                       : isNew   ? tr("%n lesson(s) assigned.", nullptr, count)
                       : isGone  ? tr("%n lesson(s) taken back; attempts stay.", nullptr, count)
                                 : tr("%n lesson(s) changed.", nullptr, count);
        if (wasUndone || noneLeft == 0)
            return done;
        return done + u' ' +
               tr("%n student(s) who have not passed have no attempts left: earlier ones count.", nullptr, noneLeft);
    };
    m_said->setText(m_saying());
    // If the focus was on a button that is now disabled, the button beside the message gets it.
    m_undo->setVisible(!m_last.isEmpty());
    updateChosen();  // a disabled button cannot take the focus
    if (!m_last.isEmpty() && std::exchange(m_hadFocus, false))
        m_undo->setFocus();
    announce(*m_said);
}

void AssignPage::refuse(const QString& sentence)
{
    m_isAsking = false;
    m_isUndoing = false;
    m_saying = {};
    m_said->setText(QStringLiteral("⚠ ") + sentence);
    m_undo->setVisible(!m_last.isEmpty());
    announce(*m_said);
    updateChosen();
}

void AssignPage::updateChosen()
{
    const auto count = static_cast<int>(ticked().size());
    m_assign->setText(count == 0 ? tr("Assign") : tr("Assign %n lesson(s)", nullptr, count));
    m_assign->setAccessibleName(m_assign->text());
    m_assign->setEnabled(count > 0 && !m_isAsking && m_overview.id.value != 0);
    updateLater();
    const bool hasChosen = !m_table->selectionModel()->selectedRows().isEmpty();
    m_change->setEnabled(hasChosen && !m_isAsking);
    m_takeBack->setEnabled(hasChosen && !m_isAsking);
    m_terms->setEnabled(hasChosen);
    if (!hasChosen)
        m_terms->reset();  // otherwise it would still show the terms of the previous selection
    m_undo->setEnabled(!m_isAsking);
}

/// Offers later versions of the chosen lessons. A class keeps the version that it was assigned until a teacher decides.
void AssignPage::updateLater()
{
    int count = 0;
    int version = 0;
    for (const database::ClassAssignment& given : chosen())
        if (const LessonOffer* later = laterVersionOf(given)) {
            ++count;
            version = later->version > given.lessonVersion ? later->version : 0;
        }
    m_update->setVisible(count > 0);
    m_update->setEnabled(count > 0 && !m_isAsking);
    //: %1: number of the version
    m_update->setText(count == 1 && version > 0 ? tr("Assign version %1 to new attempts").arg(version)
                      : count == 1              ? tr("Assign the changed lesson to new attempts")
                                                : tr("Assign %n changed lesson(s) to new attempts", nullptr, count));
    m_update->setAccessibleName(m_update->text());
    m_update->setToolTip(tr("Attempts that have been begun, and scores so far, stay with the version they were made "
                            "with."));
}

void AssignPage::retell()
{
    setTitle(tr("Assign lessons"));
    m_offersTitle->setText(tr("Lessons"));
    m_noneFits->setText(tr("No lesson fits. Search for another word."));
    m_search->setPlaceholderText(tr("Search: a word, or the number of a tooth"));
    m_search->setToolTip(m_search->placeholderText());
    m_search->setAccessibleName(tr("Search the lessons"));
    for (auto* clear : m_search->findChildren<QAbstractButton*>())
        clear->setAccessibleName(tr("Clear the search"));
    m_list->setAccessibleName(tr("Lessons to assign"));
    const QString name = QString::fromStdString(m_overview.name);
    //: %1: name of a class
    m_givenTitle->setText(tr("What %1 is to do").arg(name));
    m_table->setAccessibleName(m_givenTitle->text());
    m_rows->setHorizontalHeaderLabels({tr("Lesson"), tr("Due"), tr("Attempts"), tr("Passed")});
    m_empty->setText(tr("Nothing is assigned yet. Tick lessons on the left, say when they are due, and assign them; "
                        "here you will see how many have passed."));
    m_change->setText(tr("Change"));
    m_change->setAccessibleName(tr("Change due date and attempts of the chosen lessons"));
    m_takeBack->setText(tr("Take back"));
    m_takeBack->setAccessibleName(tr("Take the chosen lessons back"));
    if (m_saying)
        m_said->setText(m_saying());
    m_undo->setText(tr("Undo"));
    m_undo->setAccessibleName(m_undo->text());
    fillOffers();
    fillGiven();
}

void AssignPage::showEvent(QShowEvent* event)
{
    Page::showEvent(event);
    m_search->setFocus();
}

}  // namespace ui::people
