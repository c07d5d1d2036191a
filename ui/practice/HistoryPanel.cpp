// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/practice/HistoryPanel.h"
#include "core/history/MomentId.h"

#include <algorithm>
#include <numeric>

#include <QAbstractListModel>
#include <QCoreApplication>
#include <QLabel>
#include <QListView>
#include <QPainter>
#include <QPointer>
#include <QStyledItemDelegate>
#include <QThreadPool>
#include <QVBoxLayout>

#include "ui/kit/MaterialLook.h"
#include "ui/kit/Theme.h"
#include "ui/practice/Thumbnail.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::practice {

/// The rows of the history. The panel paints them; their texts are for screen readers.
class HistoryModel final : public QAbstractListModel
{
public:
    using QAbstractListModel::QAbstractListModel;

    void set(std::vector<HistoryRow> rows)
    {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
    }
    [[nodiscard]] const std::vector<HistoryRow>& rows() const { return m_rows; }
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override
    {
        return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
    }
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

private:
    std::vector<HistoryRow> m_rows;
};

namespace {

using namespace ui::kit;
using core::history::MomentId;

constexpr int kPanelPx = 248;
constexpr int kRowPx = HistoryPanel::kPicturePx + kSpace2;
constexpr int kLanePx = 14;
constexpr int kMostLanes = 5;  ///< further branches share the last lane
constexpr double kDotPx = 4.0;

std::uint64_t number(MomentId id)
{
    return static_cast<std::uint64_t>(id);
}

/// Returns the time of a moment as "1:07", or the words for the first moment.
QString whenWords(const HistoryRow& row)
{
    if (row.moment.tick == 0 && row.parent < 0)
        return QCoreApplication::translate("HistoryPanel", "Intact tooth");
    if (row.moment.tick == 0)
        return QCoreApplication::translate("HistoryPanel", "Tooth reset");
    return text::duration(row.moment.seconds);
}

/// Returns the words for the material of which most was removed.
QString takenWords(const HistoryRow& row)
{
    if (row.parent < 0 || row.moment.tick == 0)
        return {};
    const auto most = std::max_element(row.takenMm3.begin(), row.takenMm3.end());
    if (!(*most > 0.0))
        return {};
    const auto material = static_cast<core::terrain::Material>(most - row.takenMm3.begin());
    //: What a stroke took off: so many cubic millimetres of a tissue
    return QCoreApplication::translate("HistoryPanel", "%1 mm³ %2")
        .arg(text::number(*most, 2), text::materialName(material));
}

/// Paints one moment: its position among the branches, its picture and its text.
class HistoryDelegate final : public QStyledItemDelegate
{
public:
    HistoryDelegate(HistoryPanel& panel, const HistoryModel& model, QObject* parent)
        : QStyledItemDelegate(parent), m_panel(panel), m_model(model)
    {}

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override
    {
        return {kPanelPx - kSpace4, kRowPx};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const HistoryRow& row = m_model.rows().at(static_cast<std::size_t>(index.row()));
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        const QPalette colours = roomPalette();
        const QRectF area = QRectF(option.rect).adjusted(1.0, 1.0, -1.0, -1.0);
        if (option.state.testFlag(QStyle::State_MouseOver) || row.moment.isCurrent) {
            painter->setPen(Qt::NoPen);
            painter->setBrush(colours.color(QPalette::Midlight));
            painter->drawRoundedRect(area, kRadius, kRadius);
        }
        if (option.state.testFlag(QStyle::State_HasFocus)) {
            painter->setPen(QPen(colours.color(QPalette::Link), 2.0));
            painter->setBrush(Qt::NoBrush);
            painter->drawRoundedRect(area, kRadius, kRadius);
        }
        paintBranches(*painter, option.rect, row);
        paintMoment(*painter, option.rect, row);
        painter->restore();
    }

private:
    [[nodiscard]] int lanes() const
    {
        int most = 0;
        for (const HistoryRow& row : m_model.rows())
            most = std::max(most, row.lane);
        return std::min(most + 1, kMostLanes);
    }
    static double laneX(const QRectF& area, int lane)
    {
        return area.left() + kSpace2 + kLanePx * (std::min(lane, kMostLanes - 1) + 0.5);
    }

    static void paintBranches(QPainter& painter, const QRectF& area, const HistoryRow& row)
    {
        const QPalette colours = roomPalette();
        painter.setPen(QPen(colours.color(QPalette::PlaceholderText), 1.5));
        const QPointF here(laneX(area, row.lane), area.center().y());
        for (const int lane : row.fromAbove)
            painter.drawLine(QPointF(laneX(area, lane), area.top()), QPointF(laneX(area, lane), here.y()));
        for (const int lane : row.toBelow) {
            const double x = laneX(area, lane);
            const bool goesThrough = std::find(row.fromAbove.begin(), row.fromAbove.end(), lane) != row.fromAbove.end();
            painter.drawLine(goesThrough ? QPointF(x, here.y()) : here, QPointF(x, area.bottom() + 1.0));
        }
        const Tones tone = tones(colours);
        painter.setPen(QPen(row.moment.isCurrent ? tone.accent : colours.color(QPalette::PlaceholderText), 2.0));
        painter.setBrush(row.moment.isCurrent ? tone.accent : colours.color(QPalette::Base));
        const double radius = row.moment.isCurrent ? kDotPx + 1.0 : kDotPx;
        painter.drawEllipse(here, radius, radius);
    }

    void paintMoment(QPainter& painter, const QRect& area, const HistoryRow& row) const
    {
        const QPalette colours = roomPalette();
        const QRect place(area.left() + kSpace2 + lanes() * kLanePx + kSpace1,
                          area.top() + (area.height() - HistoryPanel::kPicturePx) / 2, HistoryPanel::kPicturePx,
                          HistoryPanel::kPicturePx);
        if (const QImage* picture = m_panel.picture(row.moment.id))
            painter.drawImage(place, *picture);
        else
            painter.fillRect(place, colours.color(QPalette::Base));
        const QRect words(place.right() + kSpace2, area.top(), area.right() - place.right() - kSpace2 - kSpace1,
                          area.height());
        const QString taken = takenWords(row);
        painter.setPen(colours.color(QPalette::WindowText));
        painter.setFont(typeface(kBody, row.moment.isCurrent ? QFont::DemiBold : QFont::Medium));
        const QRect upper = taken.isEmpty() ? words : words.adjusted(0, 0, 0, -area.height() / 2);
        painter.drawText(upper, (taken.isEmpty() ? Qt::AlignVCenter : Qt::AlignBottom) | Qt::AlignLeft,
                         painter.fontMetrics().elidedText(whenWords(row), Qt::ElideRight, words.width()));
        painter.setPen(colours.color(QPalette::PlaceholderText));
        painter.setFont(typeface(kSmall));
        painter.drawText(words.adjusted(0, area.height() / 2 + 1, 0, 0), Qt::AlignTop | Qt::AlignLeft,
                         painter.fontMetrics().elidedText(taken, Qt::ElideRight, words.width()));
    }

    HistoryPanel& m_panel;
    const HistoryModel& m_model;
};

}  // namespace

QVariant HistoryModel::data(const QModelIndex& index, int role) const
{
    if (role != Qt::DisplayRole && role != Qt::AccessibleTextRole)
        return {};
    const HistoryRow& row = m_rows.at(static_cast<std::size_t>(index.row()));
    QStringList words{whenWords(row), takenWords(row)};
    if (row.moment.isCurrent)
        words << QCoreApplication::translate("HistoryPanel", "present");
    words.removeAll(QString());
    return words.join(QStringLiteral(", "));
}

HistoryPanel::HistoryPanel(QWidget* parent)
    : QFrame(parent), m_model(new HistoryModel(this)), m_list(new QListView(this)), m_empty(new QLabel(this))
{
    setProperty("kind", "card");
    setObjectName(QStringLiteral("historyPanel"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpace2, kSpace2, kSpace2, kSpace2);
    auto* title = new QLabel(this);
    text::bindTranslation(title, [this, title] {
        title->setText(tr("Undo history"));
        m_list->setAccessibleName(title->text());
    });
    title->setFont(typeface(kBody, QFont::DemiBold));
    title->setContentsMargins(kSpace1, 0, 0, 0);
    column->addWidget(title);
    m_list->setProperty("kind", "plain");
    m_list->setModel(m_model);
    m_list->setItemDelegate(new HistoryDelegate(*this, *m_model, this));
    m_list->setMouseTracking(true);
    m_list->setUniformItemSizes(true);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    text::bindTranslation(m_list, [this] { m_list->setToolTip(tr("Click a state, or press Enter, to return to it")); });
    column->addWidget(m_list);
    text::bindTranslation(m_empty, [this] {
        m_empty->setText(tr("Each stroke appears here as a small picture. Click a picture to go back to it. Later "
                            "strokes stay as a separate branch."));
    });
    m_empty->setWordWrap(true);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_empty->setContentsMargins(kSpace1, 0, kSpace1, kSpace1);
    column->addWidget(m_empty);
    connect(m_list, &QListView::clicked, this, [this](const QModelIndex& index) { jumpTo(index.row()); });
    connect(m_list, &QListView::activated, this, [this](const QModelIndex& index) { jumpTo(index.row()); });
    connect(this, &HistoryPanel::pictureDrawn, m_list->viewport(), qOverload<>(&QWidget::update));
    hide();
}

void HistoryPanel::setTooth(std::shared_ptr<const core::terrain::ToothAnatomy> tooth)
{
    m_tooth = std::move(tooth);
    m_pictures.clear();
    m_underWay.clear();
    ++m_drawing;
    m_isStale = true;
}

void HistoryPanel::setColours(render::Palette colours)
{
    if (std::exchange(m_colours, colours) == colours)
        return;
    m_pictures.clear();
    m_underWay.clear();
    ++m_drawing;
    m_list->viewport()->update();
}

void HistoryPanel::follow(std::uint64_t historyVersion)
{
    m_isStale = m_isStale || historyVersion != m_version;
    m_version = historyVersion;
    if (m_isStale && isVisible())
        reload();
}

void HistoryPanel::showEvent(QShowEvent* event)
{
    QFrame::showEvent(event);
    reload();
}

void HistoryPanel::reload()
{
    m_isStale = false;
    m_model->set(m_source.moments ? historyRows(m_source.moments()) : std::vector<HistoryRow>());
    m_empty->setVisible(m_model->rowCount() < 2);
    placeIn(m_area);
    const auto& rows = m_model->rows();
    const auto present =
        std::find_if(rows.begin(), rows.end(), [](const HistoryRow& row) { return row.moment.isCurrent; });
    if (present == rows.end())
        return;
    const QModelIndex index = m_model->index(static_cast<int>(present - rows.begin()));
    m_list->setCurrentIndex(index);
    m_list->scrollTo(index);
}

const QImage* HistoryPanel::picture(MomentId id)
{
    const QImage* known = m_pictures.object(number(id));
    if (known == nullptr)
        draw(id);
    return known;
}

/// Draws the picture of a moment in the thread pool. Discards the picture if the tooth or the palette has changed
/// meanwhile.
void HistoryPanel::draw(MomentId id)
{
    if (!m_tooth || !m_source.heights || m_underWay.contains(number(id)))
        return;
    std::vector<float> top = m_source.heights(id);
    if (top.size() != m_tooth->top.size())
        return;
    m_underWay.insert(number(id));
    ThumbnailColours colours;
    for (std::size_t m = 0; m < colours.materials.size(); ++m)
        colours.materials.at(m) = materialLook(static_cast<core::terrain::Material>(m), m_colours).fill.rgb();
    colours.cut = tones(roomPalette()).accent.rgb();
    colours.beside = roomPalette().color(QPalette::Base).rgb();
    const QPointer<HistoryPanel> guard(this);
    QThreadPool::globalInstance()->start(
        [guard, id, colours, drawing = m_drawing, tooth = m_tooth, top = std::move(top)] {
            QImage drawn = thumbnail(*tooth, top, kPicturePx, colours);
            QMetaObject::invokeMethod(
                qApp,
                [guard, id, drawing, drawn] {
                    if (!guard || guard->m_drawing != drawing)
                        return;
                    guard->m_underWay.remove(number(id));
                    guard->m_pictures.insert(number(id), new QImage(drawn));
                    emit guard->pictureDrawn();
                },
                Qt::QueuedConnection);
        });
}

void HistoryPanel::jumpTo(int row)
{
    const auto& rows = m_model->rows();
    if (row >= 0 && row < static_cast<int>(rows.size()))
        emit momentRequested({rows[static_cast<std::size_t>(row)].moment.id});
}

void HistoryPanel::placeIn(const QRect& area)
{
    m_area = area;
    const int width = std::min(kPanelPx, area.width() - 2 * kSpace2);
    m_list->setFixedHeight(std::max(1, m_model->rowCount()) * kRowPx);
    // While no word-wrapping label is visible (m_empty is hidden), a layout has no height for a width.
    layout()->activate();
    const int wanted =
        layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width) : layout()->totalSizeHint().height();
    const int height = std::min(wanted, area.height() - 2 * kSpace2);
    m_list->setFixedHeight(std::max(0, m_list->height() - wanted + height));
    setGeometry(area.left() + kSpace2, area.top() + kSpace2, width, height);
}

}  // namespace ui::practice
