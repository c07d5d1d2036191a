// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/ClassModel.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QPainter>
#include <QStyleOptionHeader>

#include "lessons/NeedsHelp.h"
#include "ui/kit/Theme.h"
#include "ui/text/Search.h"
#include "ui/text/Texts.h"

namespace ui::people {

using database::MatrixCell;
using database::MatrixStudent;
using namespace ui::kit;

namespace {

constexpr double kPaleAt = 200.0;  ///< tenths of a point: up to this score a cell's background is at its faintest
constexpr double kFullTenths = 1000.0;
constexpr int kLongestExamS = 3 * 3600;
constexpr double kFaintest = 0.06;
constexpr double kFullest = 0.42;       ///< a stronger colour would make the text hard to read
constexpr QStringView kSign = u"  ▲ ";  ///< between a name and the help that the student needs
constexpr QStringView kGone = u"  – ";  ///< between the name of a disabled student and the word for it

/// Blends two colours like a translucent layer. Qt's painter takes more than ten times as long for transparency,
/// because it divides each small area among threads and waits for them.
QColor mixed(const QColor& below, const QColor& above, double share)
{
    const auto channel = [share](int a, int b) { return static_cast<int>(std::lround(a + (b - a) * share)); };
    return {channel(below.red(), above.red()), channel(below.green(), above.green()),
            channel(below.blue(), above.blue())};
}

}  // namespace

Need needOf(const MatrixStudent& student, bool hasNoneLeft, bool isLate)
{
    if (hasNoneLeft)  // first, because only the teacher can help here
        return Need::NoneLeft;
    std::vector<::lessons::AttemptOutcome> tries;
    for (std::size_t k = 0; k < std::min(student.recentTenths.size(), student.recentPassed.size()); ++k)
        tries.push_back({student.recentTenths[k], student.recentPassed[k]});
    if (::lessons::needsHelp(tries))
        return Need::Stuck;
    if (student.lastLoginUtc.empty() && student.lastAttemptUtc.empty())
        return Need::NeverLoggedIn;
    if (isLate)
        return Need::Late;
    return student.lastAttemptUtc.empty() ? Need::NotBegun : Need::Nothing;
}

QString needWord(Need need)
{
    switch (need) {
    case Need::NoneLeft:
        //: Of a student who has no attempts left at a lesson that they have not passed
        return ClassModel::tr("out of tries");
    case Need::Stuck:
        //: Of a student
        return ClassModel::tr("stuck");
    case Need::NeverLoggedIn:
        return ClassModel::tr("no login");
    case Need::Late:
        //: Of a student who has not passed a lesson that is overdue
        return ClassModel::tr("late");
    case Need::NotBegun:
        //: Of a student who has no attempt yet
        return ClassModel::tr("new");
    case Need::Nothing:
        break;
    }
    return {};
}

bool mayGoOn(const MatrixCell& cell, const QDateTime& now)
{
    return !cell.begunUtc.empty() && text::momentOf(cell.begunUtc).addSecs(kLongestExamS) > now;
}

QString nameOf(const MatrixStudent& student)
{
    return QString::fromStdString(student.fullName);
}

QString shortened(const QString& head, const QFontMetrics& metrics, int widthPx)
{
    const qsizetype sign = std::max(head.indexOf(kSign), head.indexOf(kGone));
    if (sign < 0)
        return metrics.elidedText(head, Qt::ElideRight, widthPx);
    const QString need = head.mid(sign);
    const int namePx = std::max(widthPx / 2, widthPx - metrics.horizontalAdvance(need));
    // The text in brackets, which distinguishes students of the same name, is never elided.
    const qsizetype bracket = head.left(sign).lastIndexOf(QStringLiteral(" ("));
    const QString apart = bracket > 0 && head.at(sign - 1) == u')' ? head.mid(bracket, sign - bracket) : QString();
    const QString name = metrics.elidedText(head.left(sign - apart.size()), Qt::ElideRight,
                                            std::max(0, namePx - metrics.horizontalAdvance(apart)));
    return metrics.elidedText(name + apart + need, Qt::ElideRight, widthPx);
}

NameHeads::NameHeads(QTableView* table) : QHeaderView(Qt::Vertical, table)
{
    setSectionsClickable(true);
    setHighlightSections(false);
    setDefaultSectionSize(table->verticalHeader()->defaultSectionSize());
    setSectionResizeMode(QHeaderView::Fixed);
}

void NameHeads::initStyleOptionForIndex(QStyleOptionHeader* option, int logicalIndex) const
{
    QHeaderView::initStyleOptionForIndex(option, logicalIndex);
    option->text = shortened(option->text, QFontMetrics(typeface(kBody)), width() - 2 * kSpace2 - 1);
}

void ClassModel::setOverview(const database::ClassOverview& overview, const QDateTime& now)
{
    beginResetModel();
    if (overview.id != m_overview.id)  // assignments of another class
        m_given.clear();
    m_overview = overview;
    m_now = now;
    m_overview.cells.resize(m_overview.students.size());
    for (std::vector<MatrixCell>& row : m_overview.cells)
        row.resize(m_overview.lessons.size());
    findNeeds();
    endResetModel();
}

void ClassModel::setAssignments(const QList<database::ClassAssignment>& given)
{
    m_given.clear();
    for (const database::ClassAssignment& one : given)
        if (one.classId == m_overview.id)
            m_given[one.lessonId] = one;
    findNeeds();
    retell();
}

void ClassModel::findNeeds()
{
    m_needs.clear();
    m_areLate.clear();
    for (std::size_t k = 0; k < m_overview.students.size(); ++k) {
        bool noneLeft = false;
        bool late = false;
        for (std::size_t lesson = 0; lesson < m_overview.lessons.size(); ++lesson) {
            noneLeft = noneLeft || hasNoneLeft(k, lesson);
            late = late || isLate(k, lesson);
        }
        m_needs << (m_overview.students[k].isDisabled ? Need::Nothing : needOf(m_overview.students[k], noneLeft, late));
        m_areLate << late;
    }
}

bool ClassModel::isLate(std::size_t student, std::size_t lesson) const
{
    const auto given = m_given.find(m_overview.lessons[lesson]);
    return given != m_given.end() && !given->second.dueUtc.empty() && text::momentOf(given->second.dueUtc) < m_now &&
           !m_overview.cells[student][lesson].passed && !m_overview.students[student].isDisabled;
}

bool ClassModel::isLate(const QModelIndex& index) const
{
    const auto lesson = lessonOf(index.column());
    return index.isValid() && lesson && isLate(static_cast<std::size_t>(index.row()), *lesson);
}

bool ClassModel::hasNoneLeft(std::size_t student, std::size_t lesson) const
{
    const auto given = m_given.find(m_overview.lessons[lesson]);
    const MatrixCell& cell = m_overview.cells[student][lesson];
    return given != m_given.end() && cell.isUsedUp(given->second.attemptLimit) && !mayGoOn(cell, m_now) &&
           !m_overview.students[student].isDisabled;
}

bool ClassModel::hasNoneLeft(const QModelIndex& index) const
{
    const auto lesson = lessonOf(index.column());
    return index.isValid() && lesson && hasNoneLeft(static_cast<std::size_t>(index.row()), *lesson);
}

bool ClassModel::hasDueDates() const
{
    return std::any_of(m_given.begin(), m_given.end(), [](const auto& one) { return !one.second.dueUtc.empty(); });
}

void ClassModel::setTitles(const text::LessonTitles& titles)
{
    m_titles = titles;
    retell();
}

void ClassModel::retell()
{
    if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    if (rowCount() > 0)
        emit headerDataChanged(Qt::Vertical, 0, rowCount() - 1);
}

bool ClassModel::needs(int row, Need need) const
{
    return need == Need::Late ? m_areLate[row] : m_needs[row] == need;
}

int ClassModel::count(Need need) const
{
    int count = 0;
    for (int row = 0; row < rowCount(); ++row)
        count += needs(row, need) ? 1 : 0;
    return count;
}

std::optional<std::size_t> ClassModel::lessonOf(int column)
{
    return column < kFirstLesson ? std::nullopt : std::optional(static_cast<std::size_t>(column - kFirstLesson));
}

ClassModel::Passed ClassModel::passed(std::size_t lesson) const
{
    Passed made;
    for (std::size_t k = 0; k < m_overview.students.size(); ++k)
        if (const MatrixCell& one = m_overview.cells[k][lesson];
            one.attempts > 0 && !m_overview.students[k].isDisabled) {
            ++made.tried;
            made.passed += one.passed ? 1 : 0;
        }
    return made;
}

const MatrixCell* ClassModel::cell(const QModelIndex& index) const
{
    const auto lesson = lessonOf(index.column());
    if (!index.isValid() || !lesson)
        return nullptr;
    return &m_overview.cells[static_cast<std::size_t>(index.row())][*lesson];
}

int ClassModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_overview.students.size());
}

int ClassModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : kFirstLesson + static_cast<int>(m_overview.lessons.size());
}

/// Returns one cell as a sentence, for a tooltip and for screen readers.
QString ClassModel::cellWords(const QModelIndex& index) const
{
    const MatrixStudent& student = m_overview.students[static_cast<std::size_t>(index.row())];
    const MatrixCell* one = cell(index);
    if (one == nullptr)
        return student.lastAttemptUtc.empty()
                   ? tr("%1: no attempt yet").arg(nameOf(student))
                   : tr("%1: last attempt %2").arg(nameOf(student), text::when(student.lastAttemptUtc));
    const QString who = QStringLiteral("%1, %2").arg(
        nameOf(student), text::lessonTitle(m_titles, m_overview.lessons[*lessonOf(index.column())]));
    if (one->attempts == 0 && one->withoutScore > 0)
        return (hasNoneLeft(index) ? tr("%1: begun, without a score so far, and no attempts left")
                : isLate(index)    ? tr("%1: begun, without a score so far, and overdue")
                                   : tr("%1: begun, without a score so far"))
            .arg(who);
    if (one->attempts == 0)
        return isLate(index) ? tr("%1: not tried, and overdue").arg(who) : tr("%1: not tried").arg(who);
    const QString count =
        one->inDoubt > 0
            //: %1: "4 attempts"
            ? tr("%1, of which %n do not match their recordings and do not count", nullptr, one->inDoubt)
                  .arg(tr("%n attempt(s)", nullptr, one->attempts))
            : tr("%n attempt(s)", nullptr, one->attempts);
    const QString best = text::points(one->bestTenths);
    //: %1: student and lesson; %2: points; %3: "4 attempts"; %4: a date
    return (one->passed          ? tr("%1: best %2, passed, %3, last %4")
            : hasNoneLeft(index) ? tr("%1: best %2, not passed and no attempts left, %3, last %4")
            : isLate(index)      ? tr("%1: best %2, not passed and overdue, %3, last %4")
                                 : tr("%1: best %2, not passed, %3, last %4"))
        .arg(who, best, count, text::when(one->lastUtc));
}

QVariant ClassModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const MatrixCell* one = cell(index);
    switch (role) {
    case Qt::DisplayRole:
        if (one == nullptr) {
            const std::string& last = m_overview.students[static_cast<std::size_t>(index.row())].lastAttemptUtc;
            return last.empty() ? QStringLiteral("–") : text::whenShort(last, m_now);
        }
        return (one->inDoubt > 0 ? QStringLiteral("⚠ ") : QString()) +
               (one->attempts <= one->inDoubt ? QStringLiteral("–") : text::points(one->bestTenths));
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
        return cellWords(index);
    case Qt::TextAlignmentRole:
        return QVariant(one == nullptr ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignCenter);
    default:
        return {};
    }
}

/// Returns the lesson's title with the due date below it. A tooltip also has the number of attempts.
QString ClassModel::headWords(std::size_t lesson, bool isTip) const
{
    const std::string& id = m_overview.lessons[lesson];
    QStringList words{text::lessonTitle(m_titles, id)};
    const auto given = m_given.find(id);
    if (given != m_given.end() && !given->second.dueUtc.empty())
        //: %1: a date
        words << tr("due %1").arg(isTip ? text::when(given->second.dueUtc)
                                        : text::dueShort(given->second.dueUtc, m_now));
    if (isTip && given != m_given.end() && given->second.attemptLimit > 0)
        words << tr("%n attempt(s) at most", nullptr, given->second.attemptLimit);
    if (const Passed of = passed(lesson); isTip && of.tried > 0)
        words << tr("%1 of %2 passed").arg(of.passed).arg(of.tried);
    return words.join(u'\n');
}

/// Returns the mark after a student's name, or an empty string.
QString ClassModel::markOf(int row) const
{
    return m_overview.students[static_cast<std::size_t>(row)].isDisabled
               //: Of a student whose account is closed
               ? tr("disabled")
               : needWord(m_needs[row]);
}

QVariant ClassModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Horizontal) {
        const auto lesson = lessonOf(section);
        if (role == Qt::DisplayRole || role == Qt::ToolTipRole)
            return lesson ? headWords(*lesson, role == Qt::ToolTipRole)
                          //: Column: when the student's last attempt was
                          : tr("Last");
        if (role == Qt::TextAlignmentRole)
            return QVariant(lesson ? static_cast<int>(Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap)
                                   : static_cast<int>(Qt::AlignLeft | Qt::AlignBottom));
        return {};
    }
    if (section < 0 || section >= m_needs.size())  // a header asks a filter model for row -1 when a row is removed
        return {};
    const MatrixStudent& student = m_overview.students[static_cast<std::size_t>(section)];
    switch (role) {
    case Qt::DisplayRole: {
        const QString word = markOf(section);
        if (word.isEmpty())
            return nameOf(student);
        return nameOf(student) + (student.isDisabled ? kGone : kSign).toString() + word;
    }
    case Qt::ToolTipRole:
        return student.lastLoginUtc.empty()
                   ? tr("%1, %2: never logged in").arg(nameOf(student), QString::fromStdString(student.username))
                   : tr("%1, %2: last login %3")
                         .arg(nameOf(student), QString::fromStdString(student.username),
                              text::when(student.lastLoginUtc));
    case Qt::TextAlignmentRole:
        return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    default:
        return {};
    }
}

charts::Table ClassModel::table() const
{
    charts::Table made;
    made.heads << tr("user name") << tr("name") << tr("needs") << tr("last login, UTC") << tr("last attempt, UTC");
    for (const std::string& id : m_overview.lessons) {
        const QString title = text::lessonTitle(m_titles, id);
        made.heads << tr("%1: best score").arg(title) << tr("%1: attempts").arg(title) << tr("%1: passed").arg(title);
    }
    for (std::size_t k = 0; k < m_overview.students.size(); ++k) {
        const MatrixStudent& student = m_overview.students[k];
        QList<charts::Cell> row{QString::fromStdString(student.username), QString::fromStdString(student.fullName),
                                markOf(static_cast<int>(k)), QString::fromStdString(student.lastLoginUtc),
                                QString::fromStdString(student.lastAttemptUtc)};
        for (const MatrixCell& one : m_overview.cells[k]) {
            row << (one.attempts == 0 ? charts::Cell(QString()) : charts::Cell(one.bestTenths / 10.0));
            row << charts::Cell(std::int64_t{one.attempts});
            row << charts::Cell(std::int64_t{one.passed ? 1 : 0});
        }
        made.rows << row;
    }
    return made;
}

ClassFilter::ClassFilter(ClassModel* source) : QSortFilterProxyModel(source), m_source(source)
{
    setSourceModel(source);
}

void ClassFilter::setNeed(Need need)
{
    m_need = need;
    invalidateFilter();
}

void ClassFilter::setWords(const QString& words)
{
    m_words = words.trimmed();
    invalidateFilter();
}

void ClassFilter::sort(int column, Qt::SortOrder order)
{
    m_isDescending = order == Qt::DescendingOrder;
    QSortFilterProxyModel::sort(column, order);
}

bool ClassFilter::filterAcceptsRow(int row, const QModelIndex&) const
{
    const MatrixStudent& student = m_source->overview().students[static_cast<std::size_t>(row)];
    const bool isCalledSo =
        text::holds(nameOf(student), m_words) || text::holds(QString::fromStdString(student.username), m_words);
    return isCalledSo && (m_need == Need::Nothing || m_source->needs(row, m_need));
}

bool ClassFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const
{
    // Students without a value in this column come last in both sort orders.
    const auto order = [&](bool isLeftNone, bool isRightNone, bool isLess) {
        if (isLeftNone != isRightNone)
            return isRightNone != m_isDescending;
        return isLess;
    };
    const MatrixCell* a = m_source->cell(left);
    const MatrixCell* b = m_source->cell(right);
    if (a != nullptr && b != nullptr)
        return order(a->attempts == 0, b->attempts == 0, a->bestTenths < b->bestTenths);
    const std::string& last = m_source->overview().students[static_cast<std::size_t>(left.row())].lastAttemptUtc;
    const std::string& other = m_source->overview().students[static_cast<std::size_t>(right.row())].lastAttemptUtc;
    return order(last.empty(), other.empty(), last < other);
}

void ScoreCell::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const MatrixCell* one = m_model->cell(m_filter->mapToSource(index));
    if (one == nullptr)
        return QStyledItemDelegate::paint(painter, option, index);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QPalette p = option.widget != nullptr ? option.widget->window()->palette()  // its own has no background
                                                : option.palette;
    const QRectF box = QRectF(option.rect).adjusted(1.5, 1.5, -1.5, -1.5);
    const QColor base = p.color(QPalette::Base);
    painter->fillRect(option.rect, base);  // the selection is a ring, so that the shade remains visible
    if (one->attempts > 0) {
        const double share = std::clamp((one->bestTenths - kPaleAt) / (kFullTenths - kPaleAt), 0.0, 1.0);
        painter->setPen(Qt::NoPen);
        painter->setBrush(mixed(base, tones(p).accent, kFaintest + (kFullest - kFaintest) * share));
        painter->drawRoundedRect(box, 4.0, 4.0);
    }
    if (option.state.testFlag(QStyle::State_Selected)) {
        painter->setPen(QPen(p.color(QPalette::Link), 2.0));
        painter->setBrush(Qt::NoBrush);
        painter->drawRoundedRect(box, 4.0, 4.0);
    }
    if (const QModelIndex source = m_filter->mapToSource(index);
        m_model->isLate(source) || m_model->hasNoneLeft(source)) {
        // The same triangle that follows the names of students who need help.
        const double x = box.left() + 7.0;
        const double y = box.center().y();
        painter->setPen(Qt::NoPen);
        painter->setBrush(tones(p).attention);
        painter->drawPolygon(QPolygonF{{x, y + 4.0}, {x + 4.5, y - 4.0}, {x + 9.0, y + 4.0}});
    }
    painter->setFont(typeface(kBody, one->passed ? QFont::DemiBold : QFont::Normal));
    painter->setPen(p.color(one->attempts == 0 ? QPalette::PlaceholderText : QPalette::Text));
    const QString words = index.data().toString();
    painter->drawText(box, Qt::AlignCenter, words);
    if (one->passed) {
        const double left = box.center().x() + 0.5 * painter->fontMetrics().horizontalAdvance(words) + 5.0;
        const double y = box.center().y();
        painter->setPen(QPen(p.color(QPalette::Text), 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->setBrush(Qt::NoBrush);
        painter->drawPolyline(QPolygonF{{left, y + 0.5}, {left + 3.0, y + 3.5}, {left + 8.5, y - 4.0}});
    }
    painter->restore();
}

}  // namespace ui::people
