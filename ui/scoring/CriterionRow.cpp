// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoring/CriterionRow.h"

#include <algorithm>
#include <cmath>

#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include "ui/kit/TabularDigitsLabel.h"
#include "ui/kit/Theme.h"
#include "ui/text/Texts.h"

namespace ui::scoring {
namespace {

using namespace ui::kit;
using ::lessons::Moment;

constexpr int kAbovePx = 3;        ///< margin above and below; twelve criteria fit on a screen 800 px high
constexpr int kAboveNoughtPx = 1;  ///< margin of a criterion without lost points
constexpr double kTogetherS = 10.0;
constexpr std::size_t kShownMoments = 3;
constexpr int kMostChips = 3;

QString signedPoints(int lostTenths)
{
    return lostTenths == 0 ? QStringLiteral("0") : QChar(0x2212) + text::points(lostTenths);
}

/// Returns whether a measure decreases during the work, because it measures what is left.
bool isOfWhatIsLeft(const std::string& measure)
{
    return measure.starts_with("caries_") || measure.starts_with("undercut_") || measure == "target_removed_percent";
}

/// Returns a label that passes clicks on to its row.
QLabel* words(const QString& text, int size, QFont::Weight weight, QPalette::ColorRole role, QWidget* parent)
{
    auto* made = new QLabel(text, parent);
    made->setTextFormat(Qt::PlainText);
    made->setFont(typeface(size, weight));
    made->setForegroundRole(role);
    made->setAttribute(Qt::WA_TransparentForMouseEvents);
    return made;
}

}  // namespace

std::vector<Moment> asRead(const std::vector<Moment>& moments)
{
    std::vector<Moment> read;
    for (const Moment& moment : moments) {
        if (!read.empty() && read.back().kind == moment.kind && read.back().stroke == moment.stroke &&
            moment.seconds < read.back().seconds + kTogetherS)
            read.back().lostTenths += moment.lostTenths;
        else
            read.push_back(moment);
    }
    return read;
}

QString momentWords(const Moment& moment, const ::lessons::Criterion& criterion)
{
    const QString lost = signedPoints(moment.lostTenths);
    if (moment.kind == Moment::Kind::Never) {
        if (criterion.isTooEarly)
            //: %1: points of a score that is earned only when enough of the work is done
            return CriterionRow::tr("%1 work incomplete").arg(lost);
        if (!criterion.measured)
            //: %1: points of a score. What could not be measured earns nothing
            return CriterionRow::tr("%1 not measured").arg(lost);
        if (criterion.measure.starts_with("time_"))
            //: %1: points of a score, for something that was done later than asked
            return CriterionRow::tr("%1 too late").arg(lost);
        return isOfWhatIsLeft(criterion.measure) ? CriterionRow::tr("%1 not removed").arg(lost)
                                                 //: Of a criterion that was not fulfilled at any time
                                                 : CriterionRow::tr("%1 not achieved").arg(lost);
    }
    const QString at = text::duration(std::floor(moment.seconds));
    //: %1: points lost, %2: minutes and seconds of the attempt, %3: number of a stroke of the bur
    return moment.stroke > 0 ? CriterionRow::tr("%1 at %2, stroke %3").arg(lost, at).arg(moment.stroke)
                             : CriterionRow::tr("%1 at %2").arg(lost, at);
}

CriterionRow::CriterionRow(const ::lessons::Criterion& criterion, ::lessons::Verdict verdict, QWidget* parent)
    : QAbstractButton(parent), m_criterion(criterion)
{
    setCheckable(true);
    setAutoExclusive(true);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    const QString id = QString::fromStdString(criterion.id);
    setObjectName(QStringLiteral("criterion_") + id);
    const Tones tone = tones(palette());

    m_slot = new QGridLayout(this);
    const int above = criterion.lostTenths > 0 ? kAbovePx : kAboveNoughtPx;
    m_slot->setContentsMargins(kSpace2, above, kSpace2, above);
    m_slot->setHorizontalSpacing(kSpace4);
    m_slot->setVerticalSpacing(2);
    m_slot->setColumnStretch(0, 1);
    QLabel* name = words(text::criterionName(criterion), kBody, QFont::Medium, QPalette::WindowText, this);
    name->setWordWrap(true);
    name->setMinimumHeight(1);  // takes only the height that its width needs
    m_slot->addWidget(name, 0, 0);
    auto* measured = new TabularDigitsLabel(this);
    measured->setFont(typeface(kBody));
    measured->setAlignment(Qt::AlignRight);
    measured->setText(text::criterionMeasured(criterion));
    if (criterion.measure == "sound_overcut_mm3")
        measured->setToolTip(brokenIntoLines(text::soundTissueCounted()));
    if (criterion.measure == "pulp_exposed_mm2")
        measured->setToolTip(
            brokenIntoLines(tr("The exposed area, seen from above. The side panel shows the removed volume, in mm³.")));
    m_slot->addWidget(measured, 0, 1);
    auto* lost = new TabularDigitsLabel(this);
    // The figure of a criterion without lost points is as small as its name.
    lost->setFont(typeface(criterion.lostTenths > 0 ? kTitle : kBody, QFont::DemiBold));
    lost->setAlignment(Qt::AlignRight);
    lost->setMinimumWidth(52);
    lost->setText(signedPoints(criterion.lostTenths));
    lost->setColour(criterion.lostTenths > 0 ? criterion.critical ? tone.harmText : tone.attentionText
                                             : palette().color(QPalette::PlaceholderText));
    lost->setObjectName(QStringLiteral("lost_") + id);
    //: Tooltip on the points of one criterion
    lost->setToolTip(
        criterion.capTenths > 0 ? tr("This error limits the score to %1 points").arg(text::points(criterion.capTenths))
        : criterion.critical    ? tr("The attempt fails and all remaining points are lost")
                                : tr("At most %1 points can be lost here").arg(text::points(criterion.weightTenths)));
    m_slot->addWidget(lost, 0, 2);
    m_worked = words(text::criterionWorked(criterion, verdict), kSmall, QFont::Normal, QPalette::PlaceholderText, this);
    m_worked->setWordWrap(true);
    m_worked->setMinimumHeight(1);
    m_worked->setObjectName(QStringLiteral("worked_") + id);
    m_worked->hide();
    m_slot->addWidget(m_worked, 2, 0, 1, 3);

    //: A row of a score, for the screen reader: %1 a criterion, %2 what was measured, %3 the points it cost
    setAccessibleName(tr("%1: %2, %3 points").arg(text::criterionName(criterion), measured->text(), lost->text()));
    setToolTip(tr("Show the worst place"));
}

void CriterionRow::setDetailed(bool detailed)
{
    m_worked->setVisible(detailed);
    // Hides serious errors that were not made, and limits that cost no points.
    const bool isMade = m_criterion.lostTenths > 0 || (m_criterion.capTenths == 0 && m_criterion.share > 0.0);
    setHidden(!detailed && m_criterion.critical && !isMade);
}

void CriterionRow::bePlain()
{
    setCheckable(false);
    setFocusPolicy(Qt::NoFocus);
    unsetCursor();
    setToolTip({});
}

void CriterionRow::setMoments(const std::vector<Moment>& moments)
{
    m_moments = asRead(moments);
    fillMoments(false);
}

/// Shows the costliest moments in order of time, or all of them.
void CriterionRow::fillMoments(bool all)
{
    delete m_chips;
    m_chips = nullptr;
    if (m_moments.empty())
        return;
    std::vector<Moment> shown = m_moments;
    const bool isMore = !all && shown.size() > kShownMoments;
    if (isMore) {
        std::stable_sort(shown.begin(), shown.end(),
                         [](const Moment& a, const Moment& b) { return a.lostTenths > b.lostTenths; });
        shown.resize(kShownMoments - 1);
        std::stable_sort(shown.begin(), shown.end(),
                         [](const Moment& a, const Moment& b) { return a.seconds < b.seconds; });
    }
    m_chips = new QWidget(this);
    m_chips->setCursor(Qt::ArrowCursor);
    auto* grid = new QGridLayout(m_chips);
    grid->setContentsMargins(0, 0, 0, 2);
    grid->setSpacing(kSpace1);
    grid->setColumnStretch(kMostChips, 1);
    int place = 0;
    const auto put = [&](QWidget* what) {
        grid->addWidget(what, place / kMostChips, place % kMostChips);
        ++place;
    };
    const auto add = [&](const QString& text, const QString& tip) {
        auto* chip = new QPushButton(text, m_chips);
        chip->setProperty("kind", "chip");
        chip->setFont(typeface(kSmall, QFont::Medium));
        chip->setToolTip(tip);
        chip->setStatusTip(tip);
        chip->setAccessibleName(text);
        chip->setAccessibleDescription(tip);
        chip->setAutoDefault(true);
        put(chip);
        return chip;
    };
    for (const Moment& moment : shown) {
        const QString text = momentWords(moment, m_criterion);
        if (moment.kind == Moment::Kind::Never) {  // a moment that never happened cannot be replayed
            put(words(text, kSmall, QFont::Medium, QPalette::PlaceholderText, m_chips));
            continue;
        }
        QPushButton* chip = add(text, tr("Replay the attempt from this moment"));
        connect(chip, &QPushButton::clicked, this, [this, at = moment.seconds] { emit momentRequested(at); });
    }
    if (isMore) {
        const auto rest = static_cast<int>(m_moments.size() - shown.size());
        QPushButton* more = add(tr("%n more", "moments at which points were lost", rest), tr("Show every moment"));
        connect(
            more, &QPushButton::clicked, this, [this] { fillMoments(true); }, Qt::QueuedConnection);
    }
    m_slot->addWidget(m_chips, 1, 0, 1, 3);
}

bool CriterionRow::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down) {
            event->accept();
            return true;
        }
    }
    return QAbstractButton::event(event);
}

void CriterionRow::keyPressEvent(QKeyEvent* event)
{
    const int step = event->key() == Qt::Key_Down ? 1 : event->key() == Qt::Key_Up ? -1 : 0;
    if (step == 0) {
        QAbstractButton::keyPressEvent(event);
        return;
    }
    auto rows = parentWidget()->findChildren<CriterionRow*>(QString(), Qt::FindDirectChildrenOnly);
    rows.removeIf([](const CriterionRow* row) { return row->isHidden(); });
    if (CriterionRow* next = rows.value(rows.indexOf(this) + step)) {
        next->setChecked(true);
        next->setFocus(Qt::TabFocusReason);
    }
}

void CriterionRow::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette& p = palette();
    const QRectF room = QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0);
    if (isCheckable() && (isChecked() || underMouse() || hasFocus())) {
        painter.setPen(hasFocus()    ? QPen(p.color(QPalette::Link), 2.0)
                       : isChecked() ? QPen(p.color(QPalette::Link), 1.0)
                                     : QPen(Qt::NoPen));
        painter.setBrush(isChecked() || underMouse() ? p.brush(QPalette::Midlight) : QBrush(Qt::NoBrush));
        painter.drawRoundedRect(room, kRadius, kRadius);
    }
}

}  // namespace ui::scoring
