// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>

#include <QCoreApplication>
#include <QImage>
#include <QLocale>
#include <QPicture>

#include "ui/kit/Theme.h"
#include "ui/report/Report.h"
#include "ui/report/Sheet.h"
#include "ui/scoring/AttemptCharts.h"
#include "ui/scoring/ConductNotes.h"
#include "ui/scoring/CriterionRow.h"
#include "ui/scoring/HeatMap.h"
#include "ui/scoring/ScorePage.h"
#include "ui/scoring/WorstSection.h"
#include "ui/text/Texts.h"

namespace ui::report {
namespace {

struct CardWords
{
    Q_DECLARE_TR_FUNCTIONS(ui::report::ScoreCard)
};

constexpr QSize kPicturePx{340, 301};  ///< size of the layout, in which the text is as large as the text of the page
constexpr double kPictureRatio = 3.0;  ///< device pixels per pixel of the layout
constexpr double kPicturePt = 210.0;
constexpr double kLeastPicturePt = 120.0;
constexpr double kPictureStepPt = 10.0;
constexpr double kScoreChartPt = 158.0;
constexpr int kNumberPx = 14;     ///< size of a number on a picture; also the radius of its disc
constexpr double kStemPx = 34.0;  ///< distance from the number to its place
constexpr double kTipPx = 4.0;
constexpr double kColumnGapPt = 10.0;  ///< gap before the column of points
constexpr std::size_t kMomentsTold = 3;
constexpr std::size_t kHashShown = 16;

/// Paints the numbers of the comments at their places, in order.
void paintNumbers(QPainter& painter, const scoring::HeatMap& map, const std::vector<database::AttemptComment>& comments)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(kit::typeface(kNumberPx, QFont::DemiBold));
    int number = 0;
    for (const database::AttemptComment& comment : comments) {
        if (!comment.placeMm)
            continue;
        // Beside the place, so that the place is visible; below it if there is no room above.
        const QPointF tip = map.pointOf(*comment.placeMm);
        const double up = tip.y() > kStemPx + kNumberPx ? -kStemPx : kStemPx;
        const QPointF middle = tip + QPointF(0.0, up);
        painter.setPen(QPen(Qt::white, 2.0));
        painter.setBrush(Qt::black);
        painter.drawEllipse(tip, kTipPx, kTipPx);
        painter.setPen(QPen(Qt::black, 2.0));
        painter.drawLine(tip, middle);
        painter.setPen(QPen(Qt::white, 2.0));
        painter.drawEllipse(middle, kNumberPx, kNumberPx);
        painter.drawText(QRectF(middle - QPointF(kStemPx, kStemPx), middle + QPointF(kStemPx, kStemPx)),
                         Qt::AlignCenter, QLocale().toString(++number));
    }
}

/// Returns a picture as on the score page, on white and with patterns, for readers who cannot distinguish the colours.
template <typename Picture>
QImage pictureOf(const scoring::ScoredWork& work, std::optional<std::size_t> node,
                 const std::function<void(QPainter&, const Picture&)>& paintOver = {})
{
    Picture widget(nullptr);
    widget.resize(kPicturePx);
    widget.setOnPaper(true);
    widget.setColours(render::Palette::Distinct);
    widget.setWork(work);
    if (node)
        widget.setMark(node, scoring::planeThrough(work, *node));
    QImage image(kPicturePx * kPictureRatio, QImage::Format_RGB32);
    image.setDevicePixelRatio(kPictureRatio);
    image.fill(Qt::white);
    QPainter painter(&image);
    widget.render(&painter, {}, {}, QWidget::DrawChildren);  // without the background of the theme
    if (paintOver)
        paintOver(painter, widget);
    return image;
}

/// Paints rule violations and aids as on the score page.
void paintConduct(Sheet& sheet, const scoring::ScoreCard& card)
{
    if (!card.work || !card.work->measured.process)
        return;
    QString breaches = scoring::ConductNotes::countWords(card.work->infractions);
    QStringList told;
    for (const core::grading::Infraction& infraction : card.work->infractions)
        told << scoring::ConductNotes::breachWords(infraction);
    if (!told.isEmpty())
        breaches += QStringLiteral(": ") + told.join(QStringLiteral("; "));
    sheet.say(breaches, kTextPt);
    sheet.say(text::aidWords(card.work->aids), kTextPt);
}

void paintResult(Sheet& sheet, const scoring::ScoreCard& card)
{
    const database::AttemptRecord& attempt = card.attempt;
    sheet.say(CardWords::tr("Score card: %1").arg(card.lesson), kTitlePt, QFont::DemiBold);
    //: %1: a person; %2: date and time
    sheet.say(CardWords::tr("%1, %2").arg(card.person, text::when(attempt.finishedUtc)), kHeadPt);
    sheet.skip(4.0);
    //: %1 and %2: points; %3: "Passed", "Not passed: critical error"
    sheet.say(CardWords::tr("%1 of 100 points, pass mark %2. %3")
                  .arg(text::points(attempt.countingTenths()), text::points(attempt.passMarkTenths),
                       scoring::ScorePage::verdictWords(card.sheet, attempt.givenTenths, attempt.doubt)),
              kTitlePt, QFont::DemiBold);
    if (attempt.givenTenths) {
        sheet.say(
            CardWords::tr("Given by an instructor. Automatic score: %1 points.").arg(text::points(attempt.scoreTenths)),
            kTextPt, QFont::DemiBold);
        if (!card.talk.overrides.empty()) {
            const database::AttemptOverride& given = card.talk.overrides.back();
            //: %1: a person; %2: date and time; %3: why
            sheet.say(CardWords::tr("%1, %2: %3")
                          .arg(QString::fromStdString(given.author), text::when(given.givenUtc),
                               QString::fromStdString(given.reason)),
                      kTextPt);
        }
    }
    if (attempt.expectedTenths)
        sheet.say(
            CardWords::tr("Self-assessment before the score: %1 points").arg(text::points(*attempt.expectedTenths)),
            kTextPt);
    //: "12:07"
    sheet.say(CardWords::tr("Time %1 min; cutting force: mean %2 N, maximum %3 N")
                  .arg(text::clock(attempt.durationMs), text::number(0.001 * attempt.meanForceMn, 2),
                       text::number(0.001 * attempt.peakForceMn, 2)),
              kTextPt);
    paintConduct(sheet, card);
}

QString momentsOf(const scoring::ScoreCard& card, std::size_t k)
{
    if (k >= card.moments.size())
        return {};
    QStringList told;
    const auto read = scoring::asRead(card.moments[k]);
    for (std::size_t m = 0; m < std::min(kMomentsTold, read.size()); ++m)
        told << scoring::momentWords(read[m], card.sheet.criteria[k]);
    if (read.size() > kMomentsTold)
        told << CardWords::tr("and %n more", nullptr, static_cast<int>(read.size() - kMomentsTold));
    return told.join(QStringLiteral("; "));
}

QString lostWords(const lessons::Criterion& criterion)
{
    if (criterion.weightTenths == 0)  // a limit costs no points, but decides whether the attempt passes
        return criterion.share > 0.0 ? CardWords::tr("not met") : CardWords::tr("met");
    //: Lost of a weight, both points: "−4.4 of 30.0"
    return CardWords::tr("%1 of %2")
        .arg(text::number(-0.1 * criterion.lostTenths, 1), text::points(criterion.weightTenths));
}

void paintCriteria(Sheet& sheet, const scoring::ScoreCard& card)
{
    sheet.head(CardWords::tr("Lost points"), 40.0);
    double lostWide = 0.0;
    for (const lessons::Criterion& criterion : card.sheet.criteria)
        lostWide = std::max(lostWide, sheet.widthOf(lostWords(criterion), kTextPt, QFont::DemiBold) + kColumnGapPt);
    for (std::size_t k = 0; k < card.sheet.criteria.size(); ++k) {
        const lessons::Criterion& criterion = card.sheet.criteria[k];
        const double wide = sheet.width() - lostWide;
        QStringList why{text::criterionWorked(criterion, card.sheet.verdict)};
        if (const QString moments = momentsOf(card, k); !moments.isEmpty())
            why << moments;
        const QString measured = text::criterionMeasured(criterion);
        const QString name =
            text::criterionName(criterion) + (measured.isEmpty() ? QString() : QStringLiteral(": ") + measured);
        const double nameHigh = sheet.heightOf(wide, name, kTextPt, QFont::DemiBold);
        const double whyHigh = sheet.heightOf(wide, why.join(u'\n'), kTextPt, QFont::Normal);
        sheet.need(nameHigh + whyHigh + 8.0);
        sheet.rule();
        constexpr int kLeft = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
        sheet.put(QRectF(0.0, sheet.top(), wide, nameHigh + 1.0), name, kTextPt, QFont::DemiBold, kLeft);
        sheet.put(QRectF(wide, sheet.top(), lostWide, nameHigh + 1.0), lostWords(criterion), kTextPt, QFont::DemiBold,
                  Qt::AlignRight | Qt::AlignTop);
        sheet.put(QRectF(0.0, sheet.top() + nameHigh + 1.0, wide, whyHigh + 1.0), why.join(u'\n'), kTextPt,
                  QFont::Normal, kLeft);
        sheet.skip(nameHigh + whyHigh + 4.0);
    }
    sheet.rule();
    sheet.say(scoring::ScorePage::sumWords(card.sheet, card.attempt.givenTenths), kTextPt, QFont::DemiBold);
}

/// Returns the pictures: from above, and a section through the place of the largest deviation.
QList<QImage> picturesOf(const scoring::ScoreCard& card)
{
    const auto node = scoring::farthestOff(*card.work);
    const auto numbers = [&](QPainter& painter, const scoring::HeatMap& map) {
        paintNumbers(painter, map, card.talk.comments);
    };
    return {pictureOf<scoring::HeatMap>(*card.work, node, numbers), pictureOf<scoring::WorstSection>(*card.work, node)};
}

void paintPictures(Sheet& sheet, const QList<QImage>& pictures, double mostHigh)
{
    if (pictures.isEmpty())
        return;
    const double wide = 0.5 * (sheet.width() - 10.0);
    const double high = std::min(mostHigh, wide * kPicturePx.height() / kPicturePx.width());
    const double drawn = high * kPicturePx.width() / kPicturePx.height();
    sheet.head(CardWords::tr("On the tooth, and in a section through the largest deviation"), high);
    double left = 0.0;
    for (qsizetype k = 0; k < pictures.size() && !sheet.isCounting(); ++k) {
        const QRectF box(left, sheet.top(), drawn, high);
        sheet.painter().setRenderHint(QPainter::SmoothPixmapTransform);
        sheet.painter().drawImage(box, pictures[k]);
        sheet.painter().setPen(QPen(QColor(0x80, 0x80, 0x80), 0.4));
        sheet.painter().setBrush(Qt::NoBrush);
        sheet.painter().drawRect(box);
        left += wide + 10.0;
    }
    sheet.skip(high + 4.0);
}

void paintTalk(Sheet& sheet, const scoring::ScoreCard& card)
{
    if (card.talk.comments.empty())
        return;
    const auto isNumbered = [&](const database::AttemptComment& comment) { return card.work && comment.placeMm; };
    const bool hasNumbers = std::any_of(card.talk.comments.begin(), card.talk.comments.end(), isNumbered);
    sheet.head(hasNumbers ? CardWords::tr("Comments, with the numbers of their places in the picture of the tooth")
                          : CardWords::tr("Comments"),
               20.0);
    int number = 0;
    for (const database::AttemptComment& comment : card.talk.comments) {
        const QString author = QString::fromStdString(comment.author);
        const QString at = text::when(comment.writtenUtc);
        const QString who =
            comment.momentMs
                ? CardWords::tr("%1, %2, at %3 of the replay").arg(author, at, text::clock(*comment.momentMs))
                : CardWords::tr("%1, %2").arg(author, at);
        const QString place =
            isNumbered(comment) ? QStringLiteral("(%1) ").arg(QLocale().toString(++number)) : QString();
        sheet.say(place + who + QStringLiteral(": ") + QString::fromStdString(comment.words), kTextPt);
    }
}

/// Returns a stored word that has no translation, or a dash if it is empty.
QString noted(const std::string& words)
{
    return words.empty() ? QStringLiteral("–") : QString::fromStdString(words);
}

QString deviceWords(const std::string& device)
{
    if (device == "pointer")  // stored before the kind of pointer was
        return CardWords::tr("mouse, pen or gamepad");
    if (device == "mouse")
        return CardWords::tr("mouse");
    if (device == "pen")
        return CardWords::tr("pen");
    if (device == "keyboard")
        return CardWords::tr("keyboard");
    if (device == "gamepad")
        return CardWords::tr("gamepad");
    if (device == "simulated")
        return CardWords::tr("simulated handpiece");
    if (device == "falcon")
        return QStringLiteral("Novint Falcon");
    return noted(device);
}

/// Returns the words for the method that finds the point of contact.
QString methodWords(const std::string& method)
{
    if (method == "continuous")
        //: How the point of contact is found: anywhere, not only on a lattice
        return CardWords::tr("continuous");
    if (method == "lattice")
        //: How the point of contact is found
        return CardWords::tr("on a lattice");
    if (method == "lattice16")
        //: How the point of contact is found
        return CardWords::tr("on a lattice, 16 steps a tick");
    if (method == "penalty")
        //: How force is found: the deeper inside, the harder it is pushed out
        return CardWords::tr("by depth");
    return noted(method);
}

QString viewWords(const std::string& view)
{
    if (view == "flat")
        //: A picture that is no stereo picture
        return CardWords::tr("flat");
    if (view == "red-cyan")
        return CardWords::tr("red and cyan glasses, in colour");
    if (view == "red-cyan-grey")
        return CardWords::tr("red and cyan glasses, in grey");
    if (view == "side-by-side")
        return CardWords::tr("stereo, halves side by side");
    if (view == "top-bottom")
        return CardWords::tr("stereo, halves one above the other");
    return noted(view);
}

/// Paints the conditions that must be the same to reproduce the score.
void paintCircumstances(Sheet& sheet, const scoring::ScoreCard& card)
{
    const database::AttemptRecord& attempt = card.attempt;
    const auto shown = [](const std::string& hash) { return noted(hash.substr(0, kHashShown)); };
    sheet.head(CardWords::tr("Details of grading and recording"), 40.0);
    const QString rubric =
        QString::fromStdString(lessons::inLanguage(card.sheet.rubricTitle, QLocale().name().toStdString()));
    const QString content = shown(card.sheet.rubricHash.empty() ? attempt.rubricHash : card.sheet.rubricHash);
    sheet.say(card.sheet.rubricVersion > 0
                  ? CardWords::tr("Rubric: %1, version %2, content %3")
                        .arg(rubric.isEmpty() ? noted({}) : rubric, QString::number(card.sheet.rubricVersion), content)
                  // the score sheet was not saved with the attempt
                  : CardWords::tr("Rubric: content %1").arg(content),
              kTextPt);
    sheet.say(CardWords::tr("Hardness: %1, content %2").arg(noted(attempt.preset), shown(attempt.presetHash)), kTextPt);
    sheet.say(CardWords::tr("Device: %1; contact: %2; grid: %3 columns a side; view: %4; seed: %5")
                  .arg(deviceWords(attempt.device), methodWords(attempt.method))
                  .arg(attempt.grid)
                  .arg(viewWords(attempt.viewMode), noted(attempt.seed)),
              kTextPt);
    sheet.say(CardWords::tr("Made with Cusp %1; recording %2; attempt %3")
                  .arg(noted(attempt.program), shown(attempt.recordingHash), QString::fromStdString(attempt.uid)),
              kTextPt);
    sheet.say(CardWords::tr("Not measured: undercuts and walls past 90°, because the model is a height field."),
              kTextPt);
}

int paintAll(QPainter& painter, const QSizeF& pagePt, const NextPage& next, const scoring::ScoreCard& card,
             const QList<QImage>& pictures, double picturePt)
{
    Sheet sheet(painter, pagePt, next, QStringLiteral("%1, %2").arg(card.person, card.lesson), card.proof);
    paintResult(sheet, card);
    paintCriteria(sheet, card);
    paintPictures(sheet, pictures, picturePt);
    scoring::ChartedAttempts charted;
    charted.newestFirst = card.history;
    charted.isOneLesson = true;
    charted.band = card.band;
    if (!card.history.isEmpty())
        sheet.chartRow({scoring::scoreChart(charted), scoring::speedChart(charted)}, kScoreChartPt);
    paintTalk(sheet, card);
    paintCircumstances(sheet, card);
    return sheet.pages();
}

/// Returns the largest height of the pictures that needs no additional page.
double pictureHeight(const QSizeF& pagePt, const scoring::ScoreCard& card, const QList<QImage>& pictures)
{
    const auto pages = [&](double picturePt) {
        QPicture nothing;
        QPainter painter(&nothing);
        return paintAll(painter, pagePt, {}, card, pictures, picturePt);
    };
    const int fewest = pages(kLeastPicturePt);
    double high = kPicturePt;
    while (high > kLeastPicturePt && pages(high) > fewest)
        high -= kPictureStepPt;
    return high;
}

}  // namespace

int paint(QPainter& painter, const QSizeF& pagePt, const NextPage& next, const scoring::ScoreCard& card)
{
    // While pages are counted only the number of pictures matters.
    const QList<QImage> pictures = !card.work ? QList<QImage>() : next ? picturesOf(card) : QList<QImage>(2);
    return paintAll(painter, pagePt, next, card, pictures, pictureHeight(pagePt, card, pictures));
}

}  // namespace ui::report
