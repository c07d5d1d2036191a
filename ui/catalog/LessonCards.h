// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QListView>
#include <QStyledItemDelegate>

#include "lessons/Lesson.h"

class QPainterPath;

namespace ui::catalog {

class LessonThumbs;

/// Data of a card besides its title (Qt::DisplayRole). A heading has no CardEntry.
enum CardRole {
    CardEntry = Qt::UserRole + 1,  ///< int: index of the lesson
    CardTooth,                     ///< the second line
    CardDue,                       ///< due date and class; empty: not assigned
    CardIsUsedUp,
    CardIsLate,
    CardScore,  ///< the best score; empty: not tried yet
    CardPassed,
    CardMarked,  ///< the lesson of the current attempt
    CardIsExam
};

/// Draws lessons as cards with a picture, in rows, and headings as wide as the list.
class LessonCards final : public QStyledItemDelegate
{
public:
    /// @param lessonOf  returns the lesson of a CardEntry; null: its file is invalid
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
