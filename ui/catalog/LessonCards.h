// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QListView>
#include <QStyledItemDelegate>

#include "lessons/Lesson.h"

class QPainterPath;

namespace ui::catalog {

class LessonThumbs;

/// What a card says, beside its title (Qt::DisplayRole). A heading has no CardEntry.
enum CardRole {
    CardEntry = Qt::UserRole + 1,  ///< int: which lesson
    CardTooth,                     ///< second line
    CardDue,                       ///< when it is due, who gave it; empty: not given
    CardIsUsedUp,
    CardIsLate,
    CardScore,  ///< best so far; empty: not tried yet
    CardPassed,
    CardMarked,  ///< on the table
    CardIsExam
};

/// Lessons as cards with a picture, in rows, under headings as wide as the list.
class LessonCards final : public QStyledItemDelegate
{
public:
    /// @param lessonOf  of a CardEntry; null: its file cannot be given
    LessonCards(LessonThumbs& thumbs, std::function<const ::lessons::Lesson*(int)> lessonOf, QListView* view);

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    void paintPicture(QPainter& painter, const QRectF& picture, const QPainterPath& shape,
                      const ::lessons::Lesson* lesson) const;
    void paintCard(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;

    LessonThumbs& m_thumbs;
    std::function<const ::lessons::Lesson*(int)> m_lessonOf;
    QListView* m_view;
};

}  // namespace ui::catalog
