// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/BusyOverlay.h"

#include <algorithm>

#include <QLabel>
#include <QProgressBar>
#include <QVBoxLayout>

#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::kit {
namespace {

constexpr int kBusyWidthPx = 360;

}  // namespace

BusyOverlay::BusyOverlay(QWidget* parent) : QFrame(parent), m_what(new QLabel(this))
{
    dress(*this, roomPalette());
    setProperty("kind", "card");
    setAutoFillBackground(true);
    text::bindTranslation(this, [this] { setAccessibleName(tr("Working")); });
    m_what->setFont(typeface(kBody, QFont::Medium));
    m_what->setAlignment(Qt::AlignCenter);
    m_what->setWordWrap(true);
    auto* progress = new QProgressBar(this);
    progress->setTextVisible(false);
    progress->setRange(0, 0);  // the progress is unknown
    text::bindTranslation(progress, [progress] { progress->setAccessibleName(tr("Progress")); });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpace6, kSpace4, kSpace6, kSpace6);
    column->setSpacing(kSpace4);
    column->addWidget(m_what);
    column->addWidget(progress);
    m_patience.setSingleShot(true);
    connect(&m_patience, &QTimer::timeout, this, [this] {
        placeIn(m_area);
        show();
        raise();
    });
    hide();
}

void BusyOverlay::work(const QString& what)
{
    m_what->setText(what);
    if (!m_working)
        m_patience.start(kPatienceMs);
    m_working = true;
}

void BusyOverlay::done()
{
    m_working = false;
    m_patience.stop();
    hide();
}

void BusyOverlay::placeIn(const QRect& area)
{
    m_area = area;
    const QSize size(std::min(kBusyWidthPx, area.width()), sizeHint().height());
    QRect place(QPoint(0, 0), size);
    place.moveCenter(area.center());
    setGeometry(place);
}

}  // namespace ui::kit
