// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QList>
#include <QString>

class QAbstractButton;
class QLabel;
class QLineEdit;
class QWidget;

namespace ui::kit {
class Actions;
class ScrollPane;
}  // namespace ui::kit

namespace ui::practice {

/// Shows all burs over the view: pictures to scale, grouped by shape, with sizes and numbers; a search by number, size
/// or shape; and a star for each favourite bur. Choosing a bur or pressing Esc closes the picker.
class BurPicker : public QFrame
{
    Q_OBJECT
public:
    BurPicker(kit::Actions& actions, QWidget* parent);

    /// Opens beside a widget, with an empty search field.
    void open(const QWidget& beside);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    /// One bur: its tile, and its size and number below.
    struct Cell
    {
        int bur;
        QWidget* whole;
        QAbstractButton* tile;
        QAbstractButton* star;
    };
    /// Burs of one shape under a heading.
    struct Group
    {
        QLabel* heading;
        QWidget* cells;
        QList<Cell> burs;
    };

    [[nodiscard]] Group makeGroup(int kind, QWidget* parent);
    [[nodiscard]] Cell makeCell(int bur, QWidget* parent);
    [[nodiscard]] QList<Cell> shown() const;
    void search(const QString& words);
    void takeFound();
    void showStars();
    void takeStar(int bur, bool isFavourite);
    void step(int by);

    kit::Actions& m_actions;
    QLineEdit* m_search;
    QLabel* m_none;
    QList<Group> m_groups;
};

}  // namespace ui::practice
