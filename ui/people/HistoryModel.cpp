// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/HistoryModel.h"

#include "ui/kit/Theme.h"
#include "ui/text/Texts.h"

namespace ui::people {

using database::AttemptRecord;

void HistoryModel::setAttempts(const QList<AttemptRecord>& attempts)
{
    beginResetModel();
    m_attempts = attempts;
    endResetModel();
}

void HistoryModel::setFeedback(std::map<std::int64_t, bool> isNew, bool isOwn)
{
    m_feedback = std::move(isNew);
    m_isOwn = isOwn;
    retell();
}

void HistoryModel::setTitles(const text::LessonTitles& titles)
{
    m_titles = titles;
    retell();
}

void HistoryModel::retell()
{
    if (!m_attempts.isEmpty())
        emit dataChanged(index(0, 0), index(rowCount() - 1, Columns - 1));
    emit headerDataChanged(Qt::Horizontal, 0, Columns - 1);
}

int HistoryModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_attempts.size());
}

int HistoryModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : Columns;
}

QString HistoryModel::words(const AttemptRecord& attempt, int column) const
{
    switch (column) {
    case When:
        return text::when(attempt.finishedUtc);
    case Lesson:
        return text::lessonTitle(m_titles, attempt.lessonId);
    case Score:
        return text::points(attempt.countingTenths());
    case Result:
        if (!attempt.counts())
            //: Of an attempt that does not count
            return attempt.doubt == database::Doubt::Version ? tr("practice") : QStringLiteral("⚠ ") + tr("in doubt");
        return attempt.countsAsPassed() ? tr("passed") : tr("not passed");
    case Time:
        return text::clock(attempt.durationMs);
    case Force:
        return text::number(0.001 * attempt.meanForceMn, 2) + QStringLiteral(" / ") +
               text::number(0.001 * attempt.peakForceMn, 2);
    case Feedback:
        if (const auto found = m_feedback.find(attempt.id); found != m_feedback.end())
            //: Of a teacher's feedback: to be read yet; not read by the student; read already
            return !found->second ? tr("read") : m_isOwn ? tr("new") : tr("unread");
        return {};
    default:
        return {};
    }
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const AttemptRecord& attempt = m_attempts[index.row()];
    switch (role) {
    case Qt::DisplayRole:
        return words(attempt, index.column());
    case Qt::TextAlignmentRole:
        return QVariant((index.column() >= Score && index.column() != Result ? Qt::AlignRight : Qt::AlignLeft) |
                        Qt::AlignVCenter);
    case Qt::FontRole:
        if (const auto found = m_feedback.find(attempt.id);
            index.column() == Feedback && found != m_feedback.end() && found->second)
            return kit::typeface(kit::kBody, QFont::DemiBold);
        return {};
    case Qt::ToolTipRole:
        if (index.column() == Feedback && m_feedback.count(attempt.id) > 0)
            return tr("A teacher has written about this attempt or given another score: open its grade to read it");
        if (!attempt.counts() && (index.column() == Score || index.column() == Result))
            return text::doubtWords(attempt.doubt);
        if (index.column() == Score && attempt.givenTenths)
            return tr("Given by an instructor. The machine's score: %1").arg(text::points(attempt.scoreTenths));
        if (index.column() == Force)
            return tr("Mean and highest force while cutting");
        if (index.column() == Lesson)
            return words(attempt, Lesson);
        return {};
    case Qt::AccessibleTextRole:
        return index.column() == Score && attempt.givenTenths
                   ? tr("%1, given by an instructor; the machine's score: %2")
                         .arg(words(attempt, Score), text::points(attempt.scoreTenths))
                   : words(attempt, index.column());
    default:
        return {};
    }
}

QVariant HistoryModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant((section >= Score && section != Result ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && section == Force)
        return tr("Mean and highest force while cutting");
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)  // a narrow column may elide its heading
        return {};
    switch (section) {
    case When:
        //: Column of a table of attempts
        return tr("Date");
    case Lesson:
        return tr("Lesson");
    case Score:
        return tr("Score");
    case Result:
        return tr("Result");
    case Time:
        return tr("Time");
    case Force:
        //: Newtons
        return tr("Force, N");
    case Feedback:
        //: Column of a table of attempts: what a teacher has said
        return tr("Feedback");
    default:
        return {};
    }
}

HistoryFilter::HistoryFilter(HistoryModel* source) : QSortFilterProxyModel(source), m_source(source)
{
    setSourceModel(source);
    setDynamicSortFilter(true);
}

void HistoryFilter::setLesson(const std::optional<std::string>& lessonId)
{
    m_lesson = lessonId;
    invalidateFilter();
}

bool HistoryFilter::filterAcceptsRow(int row, const QModelIndex&) const
{
    return !m_lesson || m_source->at(row).lessonId == *m_lesson;
}

bool HistoryFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const
{
    const AttemptRecord& a = m_source->at(left.row());
    const AttemptRecord& b = m_source->at(right.row());
    switch (left.column()) {
    case HistoryModel::Lesson: {
        const int order = QString::localeAwareCompare(text::lessonTitle(m_source->titles(), a.lessonId),
                                                      text::lessonTitle(m_source->titles(), b.lessonId));
        return order != 0 ? order < 0 : a.finishedUtc < b.finishedUtc;
    }
    case HistoryModel::Score:
        return a.countingTenths() < b.countingTenths();
    case HistoryModel::Result:
        return a.countsAsPassed() < b.countsAsPassed();
    case HistoryModel::Time:
        return a.durationMs < b.durationMs;
    case HistoryModel::Force:
        return a.meanForceMn < b.meanForceMn;
    case HistoryModel::Feedback: {
        // New feedback comes first in descending order.
        const auto rank = [](const QString& words, const QString& fresh) {
            return words.isEmpty() ? 0 : words == fresh ? 2 : 1;
        };
        const QString fresh = HistoryModel::tr("new");
        const int mine = rank(m_source->data(left, Qt::DisplayRole).toString(), fresh);
        const int other = rank(m_source->data(right, Qt::DisplayRole).toString(), fresh);
        return mine != other ? mine < other : a.finishedUtc < b.finishedUtc;
    }
    default:
        return a.finishedUtc < b.finishedUtc;
    }
}

}  // namespace ui::people
