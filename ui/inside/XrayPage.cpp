// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inside/XrayPage.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <QApplication>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPointer>
#include <QPushButton>
#include <QSlider>
#include <QThreadPool>
#include <QVBoxLayout>

#include "core/teeth/ToothBuilder.h"
#include "ui/inside/RadiographPicture.h"
#include "ui/kit/Actions.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::inside {
namespace {

using namespace kit;
using core::imaging::Neighbour;
using core::imaging::XrayedTooth;

constexpr int kMostAngleDeg = 90;
constexpr int kMostTiltDeg = 45;
constexpr int kStepsToDouble = 3;  ///< steps of the exposure slider that double the exposure
constexpr int kMostSteps = 2 * kStepsToDouble;
constexpr double kMarginMm = 1.0;
/// Seeds of the grain of the two films. They are constant, so that a picture can be reproduced.
constexpr std::uint64_t kGrainBefore = 1;
constexpr std::uint64_t kGrainNow = 2;
constexpr int kSavedGapPx = 16;
constexpr int kSavedWordsPx = 32;
constexpr int kSavedScale = 2;
constexpr QRgb kFilmGround = 0xFF0B0C0D;
constexpr QRgb kFilmWords = 0xFFB6BDBF;

double beamRadians(int degrees)
{
    return degrees * std::numbers::pi / 180.0;
}

}  // namespace

/// A film with its caption, scaled to fit.
class FilmView : public QWidget
{
public:
    explicit FilmView(QWidget* parent) : QWidget(parent)
    {
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
        setMinimumSize(180, 180);
    }
    void setCaption(const QString& caption)
    {
        m_caption = caption;
        setAccessibleName(caption);
        update();
    }
    void setFilm(const QImage& film)
    {
        m_film = film;
        update();
    }
    /// Sets the names of the tooth sides at the left and right edges of the film.
    void setSides(const QString& left, const QString& right)
    {
        m_left = left;
        m_right = right;
        update();
    }
    /// Returns the rectangle of the film, below the caption.
    [[nodiscard]] QRectF ground() const { return QRectF(rect()).adjusted(0, kCaptionPx, 0, 0); }
    [[nodiscard]] const QImage& film() const { return m_film; }
    [[nodiscard]] const QString& caption() const { return m_caption; }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
        painter.setPen(palette().color(QPalette::WindowText));
        painter.setFont(typeface(kBody, QFont::DemiBold));
        painter.drawText(QRect(0, 0, width(), kCaptionPx), Qt::AlignLeft | Qt::AlignVCenter, m_caption);
        QPainterPath frame;
        frame.addRoundedRect(ground(), kRadius, kRadius);
        painter.fillPath(frame, QColor(kFilmGround));
        if (m_film.isNull())
            return;
        QSizeF size(m_film.size());
        size.scale(ground().size(), Qt::KeepAspectRatio);
        QRectF where(QPointF(0, 0), size);
        where.moveCenter(ground().center());
        painter.setClipPath(frame);
        painter.drawImage(where, m_film);
        painter.setFont(typeface(kSmall));
        painter.setPen(QColor(kFilmWords));
        const QRectF words = ground().adjusted(kSpace2, kSpace2, -kSpace2, -kSpace2);
        painter.drawText(words, Qt::AlignLeft | Qt::AlignTop, m_left);
        painter.drawText(words, Qt::AlignRight | Qt::AlignTop, m_right);
    }

private:
    static constexpr int kCaptionPx = 28;
    QString m_caption;
    QString m_left;
    QString m_right;
    QImage m_film;
};

XrayPage::XrayPage(const Actions& actions, QWidget* parent)
    : Page(actions, parent), m_before(new FilmView(this)), m_now(new FilmView(this))
{
    m_before->setObjectName(QStringLiteral("filmBefore"));
    m_now->setObjectName(QStringLiteral("filmNow"));
    auto* films = new QHBoxLayout;
    films->setContentsMargins(kSpace6, 0, 0, 0);
    films->setSpacing(kSpace4);
    films->addWidget(m_before, 1);
    films->addWidget(m_now, 1);
    body()->addLayout(films, 1);
    body()->addWidget(makeControls(actions));
    text::bindTranslation(this, [this] { retranslateUi(); });
}

void XrayPage::retranslateUi()
{
    m_before->setCaption(tr("Before"));
    m_now->setCaption(tr("Now"));
    updateValues();
    if (!m_tooth) {
        setTitle(tr("X-ray"));
        return;
    }
    const core::terrain::ToothAnatomy& anatomy = *m_tooth->anatomy;
    //: %1 is "Tooth 36" or a file name
    setTitle(tr("X-ray: %1").arg(text::toothTitle(anatomy)));
    m_bitewing->setToolTip(
        brokenIntoLines(core::teeth::standsInTheArch(anatomy)
                            ? tr("The crown between two sound neighbours made by Cusp, with contact points.")
                        : core::teeth::isGenerated(anatomy)
                            ? tr("This tooth lies on a side, so it gets no neighbours.")
                            : tr("Nothing in a scan says which side is mesial, so it gets no neighbours.")));
    nameSides();
}

/// Labels the edges of the films with the sides of the tooth.
void XrayPage::nameSides()
{
    const double right = ownBeam().angleRad - 0.5 * std::numbers::pi;
    for (FilmView* view : {m_before, m_now})
        view->setSides(text::sideName(*m_tooth->anatomy, right + std::numbers::pi),
                       text::sideName(*m_tooth->anatomy, right));
}

QWidget* XrayPage::makeControls(const Actions& actions)
{
    auto* holder = new QWidget(this);
    auto* outer = new QVBoxLayout(holder);
    outer->setContentsMargins(kSpace6, 0, 0, 0);
    outer->setSpacing(kSpace4);
    auto* card = new QFrame(holder);
    card->setProperty("kind", "card");
    outer->addWidget(card);
    auto* row = new QHBoxLayout(card);
    row->setContentsMargins(kSpace4, kSpace2, kSpace4, kSpace2);
    row->setSpacing(kSpace4);

    addScenes(row, card);
    addSliders(row, card);

    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(kSpace2);
    auto* says = new QLabel(holder);
    text::bindTranslation(
        says, [says] { says->setText(tr("Simulated: a parallel beam, no scatter, no bone and no gums.")); });
    says->setFont(typeface(kSmall));
    says->setWordWrap(true);
    says->setForegroundRole(QPalette::PlaceholderText);
    buttons->addWidget(says, 1);
    m_save = new QPushButton(holder);
    text::bindTranslation(m_save, [this] {
        m_save->setText(tr("Save the picture …"));
        m_save->setToolTip(tr("Save both films side by side as a PNG file"));
    });
    m_save->setFocusPolicy(Qt::TabFocus);
    m_save->setAutoDefault(true);
    m_save->setObjectName(QStringLiteral("saveFilms"));
    connect(m_save, &QPushButton::clicked, this, &XrayPage::saveRequested);
    buttons->addWidget(m_save);
    m_back = pageButton(actions.back, "filled", holder);
    buttons->addWidget(m_back);
    outer->addLayout(buttons);
    return holder;
}

/// Adds the choice between one tooth and a bitewing.
void XrayPage::addScenes(QHBoxLayout* row, QWidget* card)
{
    const auto segment = [&](const char* words, const char* tip, const char* objectName) {
        auto* button = new QPushButton(card);
        text::bindTranslation(button, [button, words, tip] {
            button->setText(tr(words));
            if (tip != nullptr)
                button->setToolTip(brokenIntoLines(tr(tip)));
        });
        button->setProperty("kind", "segment");
        button->setCheckable(true);
        button->setAutoExclusive(true);
        button->setFocusPolicy(Qt::TabFocus);
        button->setObjectName(QString::fromLatin1(objectName));
        connect(button, &QPushButton::toggled, this, [this](bool on) {
            if (on)
                develop();
        });
        return button;
    };
    auto* scenes = new QVBoxLayout;
    scenes->setSpacing(kSpace1);
    m_oneTooth = segment(QT_TR_NOOP("One tooth"), QT_TR_NOOP("The whole tooth with its root"), "oneTooth");
    m_bitewing = segment(QT_TR_NOOP("Bitewing"), nullptr, "bitewing");
    m_oneTooth->setChecked(true);
    scenes->addWidget(m_oneTooth);
    scenes->addWidget(m_bitewing);
    row->addLayout(scenes);
}

/// Adds the sliders for the direction of the beam and the exposure.
void XrayPage::addSliders(QHBoxLayout* row, QWidget* card)
{
    const auto slider = [&](const char* caption, const char* tip, int low, int high, const char* objectName,
                            TabularDigitsLabel*& value, const QString& widest) {
        auto* block = new QGridLayout;
        block->setVerticalSpacing(0);
        auto* words = new QLabel(card);
        words->setFont(typeface(kSmall));
        words->setForegroundRole(QPalette::PlaceholderText);
        value = new TabularDigitsLabel(card);
        value->setFont(typeface(kBody, QFont::Medium));
        value->setAlignment(Qt::AlignRight);
        value->setText(widest);
        value->setFixedWidth(value->sizeHint().width());
        auto* made = new QSlider(Qt::Horizontal, card);
        made->setRange(low, high);
        made->setFocusPolicy(Qt::TabFocus);
        text::bindTranslation(made, [made, words, caption, tip] {
            words->setText(tr(caption));
            made->setAccessibleName(tr(caption));
            made->setToolTip(tr(tip));
            made->setStatusTip(tr(tip));
        });
        made->setObjectName(QString::fromLatin1(objectName));
        words->setBuddy(made);
        connect(made, &QSlider::valueChanged, this, [this] {
            updateValues();
            develop();
        });
        block->addWidget(words, 0, 0);
        block->addWidget(value, 0, 1, Qt::AlignRight);
        block->addWidget(made, 1, 0, 1, 2);
        row->addLayout(block, 1);
        return made;
    };
    m_angle = slider(QT_TR_NOOP("Beam from the side"), QT_TR_NOOP("Turns the beam about the tooth"), -kMostAngleDeg,
                     kMostAngleDeg, "beamAngle", m_angleText, QStringLiteral("−90°"));
    m_tilt = slider(QT_TR_NOOP("Beam from above"), QT_TR_NOOP("Tilts the beam; 0 is level"), -kMostTiltDeg,
                    kMostTiltDeg, "beamTilt", m_tiltText, QStringLiteral("−45°"));
    m_exposure =
        slider(QT_TR_NOOP("Exposure"), QT_TR_NOOP("More radiation: a darker film with less grain"), -kMostSteps,
               kMostSteps, "exposure", m_exposureText, text::number(0.25, 2) + QStringLiteral("×"));
    for (QSlider* angle : {m_angle, m_tilt})
        angle->setPageStep(15);
}

void XrayPage::showEvent(QShowEvent* event)
{
    Page::showEvent(event);
    m_back->setFocus();
}

void XrayPage::resizeEvent(QResizeEvent* event)
{
    Page::resizeEvent(event);
    develop();
}

void XrayPage::setTooth(const core::terrain::Tooth& tooth)
{
    const bool another = !m_tooth || m_tooth->anatomy != tooth.anatomy;
    m_tooth = tooth;
    if (another) {
        m_neighbours.reset();
        m_before->setFilm({});
        m_now->setFilm({});
        m_exposure->setValue(0);
    }
    const bool ours = core::teeth::standsInTheArch(*tooth.anatomy);
    m_bitewing->setEnabled(ours);
    if (!ours)
        m_oneTooth->setChecked(true);
    retranslateUi();
    develop();
}

/// Returns the beam in the tooth's own frame.
core::imaging::Beam XrayPage::ownBeam() const
{
    core::imaging::Beam beam;
    beam.angleRad += beamRadians(m_angle->value());
    // The beam comes from above. The film of an upper tooth is flipped.
    beam.tiltRad = (m_tooth && isUpper(m_tooth->anatomy->fdi) ? 1.0 : -1.0) * beamRadians(m_tilt->value());
    return beam;
}

XrayPage::Wish XrayPage::wish() const
{
    Wish now;
    now.beam = m_tooth ? core::imaging::laidBeam(m_tooth->anatomy->lying, ownBeam()) : ownBeam();
    now.exposure = std::exp2(static_cast<double>(m_exposure->value()) / kStepsToDouble);
    now.bitewing = m_bitewing->isChecked();
    const QRectF room = m_now->ground();
    now.widthToHeight = room.width() / std::max(1.0, room.height());
    return now;
}

void XrayPage::updateValues()
{
    const auto degrees = [](int value) { return text::number(value, 0) + QStringLiteral("°"); };
    m_angleText->setText(degrees(m_angle->value()));
    m_tiltText->setText(degrees(m_tilt->value()));
    m_exposureText->setText(text::number(wish().exposure, 2) + QStringLiteral("×"));
}

XrayPage::Films XrayPage::filmsOf(const core::terrain::Tooth& tooth, const Wish& wish,
                                  std::shared_ptr<const std::vector<Neighbour>> neighbours)
{
    const core::terrain::Tooth whole(tooth.anatomy);
    std::vector<XrayedTooth> teeth{{&whole}};
    if (wish.bitewing && !neighbours)
        if (auto made = core::imaging::neighboursOf(*tooth.anatomy))
            neighbours = std::make_shared<const std::vector<Neighbour>>(std::move(*made));
    if (wish.bitewing && neighbours)
        for (const Neighbour& neighbour : *neighbours)
            teeth.push_back(neighbour.xrayed());
    core::imaging::FilmArea area = wish.bitewing ? core::imaging::bitewingArea(teeth, wish.beam)
                                                 : core::imaging::shadowArea(teeth, wish.beam, kMarginMm);
    // Widens the film to the room available. A higher film would show roots, which a bitewing does not.
    const glm::dvec2 size = area.highMm - area.lowMm;
    const double wider = 0.5 * std::max(0.0, size.y * wish.widthToHeight - size.x);
    area.lowMm.x -= wider;
    area.highMm.x += wider;
    Films films;
    films.before = radiographPicture(teeth, wish.beam, area, kFilmPixelMm, {wish.exposure, kGrainBefore});
    teeth.front().tooth = &tooth;
    films.now = radiographPicture(teeth, wish.beam, area, kFilmPixelMm, {wish.exposure, kGrainNow});
    films.neighbours = std::move(neighbours);
    return films;
}

void XrayPage::develop()
{
    if (!m_tooth)
        return;
    if (m_working) {
        m_again = true;
        return;
    }
    m_working = true;
    nameSides();
    m_save->setEnabled(false);
    QThreadPool::globalInstance()->start(
        [page = QPointer<XrayPage>(this), tooth = *m_tooth, wish = wish(), neighbours = m_neighbours] {
            const Films films = filmsOf(tooth, wish, neighbours);
            QMetaObject::invokeMethod(
                qApp,
                [page, films, of = tooth.anatomy.get()] {
                    if (page)
                        page->take(films, of);
                },
                Qt::QueuedConnection);
        });
}

void XrayPage::take(const Films& films, const core::terrain::ToothAnatomy* of)
{
    m_working = false;
    if (m_tooth->anatomy.get() == of) {
        m_before->setFilm(films.before);
        m_now->setFilm(films.now);
        m_neighbours = films.neighbours;
        m_save->setEnabled(true);
    }
    if (std::exchange(m_again, false))
        develop();
}

QImage XrayPage::bothFilms() const
{
    if (m_now->film().isNull())
        return {};
    const QSize film = m_now->film().size() * kSavedScale;
    QImage both(2 * film.width() + 3 * kSavedGapPx, film.height() + kSavedGapPx + kSavedWordsPx, QImage::Format_RGB32);
    both.fill(QColor(kFilmGround));
    QPainter painter(&both);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setFont(typeface(kTitle));
    painter.setPen(Qt::white);
    int x = kSavedGapPx;
    for (const FilmView* view : {m_before, m_now}) {
        const QRect where(QPoint(x, kSavedGapPx), film);
        painter.drawImage(where, view->film());
        painter.drawText(QRect(x, where.bottom() + 1, film.width(), kSavedWordsPx), Qt::AlignCenter, view->caption());
        x += film.width() + kSavedGapPx;
    }
    return both;
}

}  // namespace ui::inside
