// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/practice/BurPicker.h"

#include <algorithm>
#include <array>

#include <QAction>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QScreen>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/bur/Bur.h"
#include "ui/kit/Actions.h"
#include "ui/kit/ScrollPane.h"
#include "ui/kit/Theme.h"
#include "ui/practice/BurChooser.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::practice {
namespace {

using core::bur::Bur;
using Shape = core::bur::BurShape;

constexpr int kPickerTilePx = 118;
constexpr int kCellPx = 104;
constexpr int kColumns = 7;
constexpr int kPickerHeightPx = 560;

constexpr std::array<const char*, 6> kGroups{
    QT_TRANSLATE_NOOP("ui::practice::BurPicker", "Round"),
    QT_TRANSLATE_NOOP("ui::practice::BurPicker", "Inverted cone"),
    QT_TRANSLATE_NOOP("ui::practice::BurPicker", "Straight fissure"),
    QT_TRANSLATE_NOOP("ui::practice::BurPicker", "Tapered fissure"),
    QT_TRANSLATE_NOOP("ui::practice::BurPicker", "Pear, egg and flame"),
    QT_TRANSLATE_NOOP("ui::practice::BurPicker", "Diamonds"),
};

/// Returns the index of a bur's group in kGroups.
int kindOf(const Bur& bur)
{
    if (bur.isDiamond())
        return 5;
    switch (bur.shape) {
    case Shape::Round:
        return 0;
    case Shape::InvertedCone:
        return 1;
    case Shape::Straight:
    case Shape::StraightCrosscut:
    case Shape::DomedCrosscut:
    case Shape::Cylinder:
        return 2;
    case Shape::Tapered:
    case Shape::TaperedCrosscut:
    case Shape::RoundEndTaper:
    case Shape::Chamfer:
        return 3;
    case Shape::Pear:
    case Shape::LongPear:
    case Shape::Egg:
    case Shape::Flame:
        break;
    }
    return 4;
}

const Bur& thatBur(int index)
{
    return core::bur::burs()[static_cast<std::size_t>(index)];
}

/// Returns "1.0 × 3.8 mm", the ISO size, and the grit of a diamond.
QString sizeWords(const Bur& bur)
{
    const QLocale locale;
    //: Diameter and length of a bur
    const QString size =
        BurPicker::tr("%1 × %2 mm")
            .arg(locale.toString(2.0 * bur.headRadiusMm, 'f', 1), locale.toString(bur.headLengthMm, 'f', 1)) +
        //: Size of a bur as in ISO 6360
        u'\n' + BurPicker::tr("ISO %1").arg(QString::fromStdString(bur.isoSize()));
    //: Of a diamond bur: number of its grit in ISO 6360, such as 524
    return bur.isDiamond() ? size + u'\n' + BurPicker::tr("Grit %1").arg(bur.grit) : size;
}

/// Returns whether a bur matches a search: its number begins with the words, or its size, its ISO 6360 number or its
/// name contains them.
bool isMeant(int index, const QString& words)
{
    const Bur& bur = thatBur(index);
    const QString number = QString::fromStdString(bur.id);
    return words.isEmpty() || number.startsWith(words, Qt::CaseInsensitive) ||
           QString::fromStdString(bur.isoSize()).startsWith(words) ||
           QString::fromStdString(bur.iso6360).remove(u' ').contains(QString(words).remove(u' ')) ||
           text::burName(bur.id).contains(words, Qt::CaseInsensitive);
}

}  // namespace

BurPicker::BurPicker(kit::Actions& actions, QWidget* parent)
    : QFrame(parent, Qt::Popup), m_actions(actions), m_search(new QLineEdit(this)), m_none(new QLabel(this))
{
    kit::dress(*this, kit::roomPalette());
    setProperty("kind", "card");
    setObjectName(QStringLiteral("burPicker"));
    m_search->setObjectName(QStringLiteral("burSearch"));
    m_none->setObjectName(QStringLiteral("burNone"));
    auto* content = new QWidget;
    auto* groups = new QVBoxLayout(content);
    groups->setContentsMargins(0, 0, 0, 0);
    groups->setSpacing(kit::kSpace2);
    for (int kind = 0; kind < static_cast<int>(kGroups.size()); ++kind) {
        m_groups << makeGroup(kind, content);
        groups->addWidget(m_groups.back().heading);
        groups->addWidget(m_groups.back().cells);
    }
    groups->addStretch(1);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(kit::kSpace4, kit::kSpace4, kit::kSpace4, kit::kSpace4);
    all->setSpacing(kit::kSpace2);
    all->addWidget(m_search);
    all->addWidget(m_none);
    auto* pane = new kit::ScrollPane(content, QPalette::Base, this);
    all->addWidget(pane, 1);
    text::bindTranslation(this, [this] {
        setAccessibleName(tr("All burs"));
        m_search->setPlaceholderText(tr("Search by number, ISO size or shape"));
        m_search->setAccessibleName(m_search->placeholderText());
        m_none->setText(tr("There is no such bur."));
        for (qsizetype k = 0; k < m_groups.size(); ++k)
            m_groups[k].heading->setText(tr(kGroups.at(static_cast<std::size_t>(k))));
        showStars();
    });
    connect(m_search, &QLineEdit::textChanged, this, &BurPicker::search);
    connect(&m_actions, &kit::Actions::bursAtHandChanged, this, &BurPicker::showStars);
    setFixedSize(kColumns * kCellPx + 2 * kit::kSpace4 + kit::kSpace6, kPickerHeightPx);
    hide();
}

BurPicker::Group BurPicker::makeGroup(int kind, QWidget* parent)
{
    Group group{new QLabel(parent), new QWidget(parent), {}};
    group.heading->setFont(kit::typeface(kit::kBody, QFont::DemiBold));
    auto* grid = new QGridLayout(group.cells);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(0);
    grid->setColumnStretch(kColumns, 1);
    QList<int> burs;
    for (int k = 0; k < static_cast<int>(core::bur::burs().size()); ++k)
        if (kindOf(thatBur(k)) == kind)
            burs << k;
    std::stable_sort(burs.begin(), burs.end(), [](int a, int b) {
        return std::pair(thatBur(a).shape, thatBur(a).headRadiusMm) <
               std::pair(thatBur(b).shape, thatBur(b).headRadiusMm);
    });
    for (const int bur : std::as_const(burs))
        group.burs << makeCell(bur, group.cells);
    return group;
}

BurPicker::Cell BurPicker::makeCell(int bur, QWidget* parent)
{
    auto* whole = new QWidget(parent);
    whole->setFixedWidth(kCellPx);
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(2, 0, 2, kit::kSpace1);
    column->setSpacing(0);
    auto* tile = new BurTile(thatBur(bur), m_actions.burs[bur], kPickerTilePx, whole);
    tile->setFixedHeight(kPickerTilePx);
    column->addWidget(tile);
    auto* size = new QLabel(whole);
    size->setFont(kit::typeface(kit::kSmall));
    size->setAlignment(Qt::AlignCenter);
    size->setForegroundRole(QPalette::PlaceholderText);
    column->addWidget(size);
    auto* star = new QToolButton(whole);
    star->setCheckable(true);
    star->setAutoRaise(true);
    star->setFocusPolicy(Qt::TabFocus);
    column->addWidget(star, 0, Qt::AlignHCenter);
    tile->installEventFilter(this);
    star->installEventFilter(this);
    text::bindTranslation(whole, [size, bur] { size->setText(sizeWords(thatBur(bur))); });
    connect(tile, &QAbstractButton::clicked, this, &QWidget::hide);
    connect(star, &QAbstractButton::clicked, this, [this, bur](bool checked) { takeStar(bur, checked); });
    return {bur, whole, tile, star};
}

void BurPicker::open(const QWidget& beside)
{
    m_search->clear();
    search({});
    showStars();
    const QPoint corner = beside.mapToGlobal(QPoint(-width() - kit::kSpace2, beside.height() - height()));
    const QRect room = beside.screen()->availableGeometry();
    move(std::clamp(corner.x(), room.left(), std::max(room.left(), room.right() - width())),
         std::clamp(corner.y(), room.top(), std::max(room.top(), room.bottom() - height())));
    show();
    m_search->setFocus(Qt::PopupFocusReason);
}

QList<BurPicker::Cell> BurPicker::shown() const
{
    QList<Cell> cells;
    for (const Group& group : m_groups)
        for (const Cell& cell : group.burs)
            if (!cell.whole->isHidden())
                cells << cell;
    return cells;
}

void BurPicker::search(const QString& words)
{
    const QString wanted = words.trimmed();
    for (const Group& group : std::as_const(m_groups)) {
        auto* grid = static_cast<QGridLayout*>(group.cells->layout());
        int place = 0;
        for (const Cell& cell : group.burs) {
            grid->removeWidget(cell.whole);
            const bool isSeen = isMeant(cell.bur, wanted);
            cell.whole->setVisible(isSeen);
            if (isSeen) {
                grid->addWidget(cell.whole, place / kColumns, place % kColumns);
                ++place;
            }
        }
        group.heading->setVisible(place > 0);
        group.cells->setVisible(place > 0);
    }
    m_none->setText(tr("There is no such bur."));
    m_none->setVisible(shown().isEmpty());
}

/// Selects the bur whose number was typed in full, otherwise the first match.
void BurPicker::takeFound()
{
    const QList<Cell> cells = shown();
    const QString words = m_search->text().trimmed();
    auto found = std::find_if(cells.begin(), cells.end(), [&](const Cell& cell) {
        return QString::fromStdString(thatBur(cell.bur).id).compare(words, Qt::CaseInsensitive) == 0;
    });
    if (found == cells.end())
        found = std::find_if(cells.begin(), cells.end(), [](const Cell& cell) { return cell.tile->isEnabled(); });
    if (found != cells.end() && found->tile->isEnabled()) {
        found->tile->click();
        return;
    }
    if (!cells.isEmpty())
        m_none->setText(tr("This lesson does not allow it."));
    m_none->show();
}

void BurPicker::showStars()
{
    const QList<int>& favourites = m_actions.favouriteBurs();
    const bool isFull = favourites.size() == kit::Actions::kMostFavouriteBurs;
    for (const Group& group : std::as_const(m_groups)) {
        for (const Cell& cell : group.burs) {
            const bool is = favourites.contains(cell.bur);
            cell.star->setChecked(is);
            cell.star->setText(is ? QStringLiteral("★") : QStringLiteral("☆"));
            cell.star->setEnabled(is || !isFull);
            cell.star->setToolTip(is       ? tr("Take it out of the panel")
                                  : isFull ? tr("The panel holds four burs: take one out first.")
                                           : tr("Keep it at hand in the panel"));
            cell.star->setAccessibleName(
                //: %1: a bur such as "Pear, No. 330"
                tr("Keep at hand: %1").arg(text::burName(thatBur(cell.bur).id)));
        }
    }
}

void BurPicker::takeStar(int bur, bool isFavourite)
{
    QList<int> favourites = m_actions.favouriteBurs();
    favourites.removeAll(bur);
    if (isFavourite)
        favourites << bur;
    m_actions.setFavouriteBurs(favourites);
}

/// Moves the focus by a number of visible tiles.
void BurPicker::step(int by)
{
    const QList<Cell> cells = shown();
    qsizetype at = -1;
    for (qsizetype k = 0; k < cells.size(); ++k)
        if (cells[k].tile->hasFocus() || cells[k].star->hasFocus())
            at = k;
    const qsizetype next = at < 0 ? 0 : at + by;
    if (next >= 0 && next < cells.size())
        cells[next].tile->setFocus(Qt::TabFocusReason);
    else if (next < 0)
        m_search->setFocus(Qt::TabFocusReason);
}

/// Handles the arrow keys the same way wherever the focus is. Buttons would move the focus to the next button.
bool BurPicker::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::KeyPress)
        return QFrame::eventFilter(watched, event);
    auto* key = static_cast<QKeyEvent*>(event);
    constexpr std::array kArrows{Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down};
    const bool isArrow = std::find(kArrows.begin(), kArrows.end(), key->key()) != kArrows.end();
    if (isArrow)
        keyPressEvent(key);
    return isArrow;
}

void BurPicker::keyPressEvent(QKeyEvent* event)
{
    const bool searches = m_search->hasFocus();
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter: {
        if (searches)
            return takeFound();
        const QList<Cell> cells = shown();
        for (const Cell& cell : cells)
            if (cell.tile->hasFocus() && cell.tile->isEnabled()) {
                cell.tile->click();
                return;
            }
        return;
    }
    case Qt::Key_Right:
        return step(1);
    case Qt::Key_Left:
        return step(-1);
    case Qt::Key_Down:
        return step(searches ? 1 : kColumns);
    case Qt::Key_Up:
        return step(-kColumns);
    default:
        QFrame::keyPressEvent(event);
    }
}

}  // namespace ui::practice
