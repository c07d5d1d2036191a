// SPDX-License-Identifier: GPL-3.0-or-later
// The printed sheets for head tracking have exact sizes.
#include <algorithm>
#include <cmath>

#include <QImage>
#include <QPainter>
#include <QTest>
#include <QTransform>

#include "core/tracking/BoardCalibration.h"
#include "core/tracking/TagDetector.h"
#include "ui/devices/TagSheet.h"

using core::tracking::BoardCalibration;
using core::tracking::PictureView;
using core::tracking::SeenTag;
using core::tracking::TagDetector;
using ui::devices::TagSheet;

namespace {

constexpr double kDotsPerMm = 300.0 / 25.4;
constexpr double kMostError = 0.005;
constexpr int kId = 7;
const QSizeF kA4(210.0, 297.0);
const QSizeF kLetter(215.9, 279.4);

QImage painted(TagSheet::Page page, const QSizeF& paperMm)
{
    QImage image((paperMm * kDotsPerMm).toSize(), QImage::Format_Grayscale8);
    image.setDotsPerMeterX(qRound(1000.0 * kDotsPerMm));
    image.setDotsPerMeterY(qRound(1000.0 * kDotsPerMm));
    image.fill(Qt::white);
    QPainter painter(&image);
    TagSheet(kId, core::tracking::cellsOf(kId)).paint(painter, page, paperMm);
    return image;
}

PictureView view(const QImage& image)
{
    return {image.constBits(), image.width(), image.height(), static_cast<int>(image.bytesPerLine())};
}

/// Returns the edge lengths of the detected tags, largest first.
std::vector<double> edgesMm(const QImage& image)
{
    TagDetector detector(kId);
    std::vector<double> edges;
    for (const SeenTag& tag : detector.find(view(image), {2, true}))
        edges.push_back(tag.edgePx() / kDotsPerMm);
    std::sort(edges.rbegin(), edges.rend());
    return edges;
}

/// Returns the length of the longest horizontal dark line.
double longestLineMm(const QImage& image)
{
    constexpr int kDark = 128;
    int longest = 0;
    for (int y = 0; y < image.height(); ++y) {
        const uchar* const row = image.constScanLine(y);
        int length = 0;
        for (int x = 0; x < image.width(); ++x) {
            length = row[x] < kDark ? length + 1 : 0;
            longest = std::max(longest, length);
        }
    }
    return longest / kDotsPerMm;
}

bool isExact(double mm, double wanted)
{
    return std::abs(mm - wanted) < kMostError * wanted;
}

}  // namespace

class TestTagSheet : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        if (!core::tracking::hasTagDetector())
            QSKIP("This program is built without head tracking.");
    }

    void tagsHaveTheirSize()
    {
        const auto edges = edgesMm(painted(TagSheet::Page::Tags, kA4));
        QCOMPARE(edges.size(), TagSheet::kEdgesMm.size());
        for (std::size_t n = 0; n < edges.size(); ++n)
            QVERIFY2(isExact(edges[n], TagSheet::kEdgesMm.at(n)), qPrintable(QString::number(edges[n])));
        const auto onBand = edgesMm(painted(TagSheet::Page::Headband, kA4));
        QCOMPARE(onBand.size(), std::size_t{1});
        QVERIFY2(isExact(onBand.front(), TagSheet::kBandEdgeMm), qPrintable(QString::number(onBand.front())));
    }

    void theBoardIsFound()
    {
        BoardCalibration calibration;
        const QImage image = painted(TagSheet::Page::Board, kA4)
                                 .scaledToWidth(800, Qt::SmoothTransformation)
                                 .convertToFormat(QImage::Format_Grayscale8);
        QCOMPARE(calibration.take(view(image)), BoardCalibration::Look::Taken);
    }

    void eachPageHasARulerOf100Mm_data()
    {
        QTest::addColumn<TagSheet::Page>("page");
        QTest::newRow("tags") << TagSheet::Page::Tags;
        QTest::newRow("headband") << TagSheet::Page::Headband;
        QTest::newRow("board") << TagSheet::Page::Board;
    }

    void eachPageHasARulerOf100Mm()
    {
        QFETCH(TagSheet::Page, page);
        const QImage image = painted(page, kA4);
        const bool isUpright = page == TagSheet::Page::Board;
        const double mm = longestLineMm(isUpright ? image.transformed(QTransform().rotate(90.0)) : image);
        QVERIFY2(isExact(mm, TagSheet::kRulerMm), qPrintable(QString::number(mm)));
    }

    /// Printers cannot print on the margin.
    void nothingIsNearTheEdgeOfThePaper()
    {
        for (const TagSheet::Page page : TagSheet::kPages)
            for (const QSizeF& paper : {kA4, kLetter}) {
                QImage image = painted(page, paper);
                constexpr int kMargin = static_cast<int>(10.0 * kDotsPerMm);
                QPainter(&image).fillRect(image.rect().adjusted(kMargin, kMargin, -kMargin, -kMargin), Qt::white);
                QImage white(image.size(), image.format());
                white.fill(Qt::white);
                QVERIFY(std::equal(image.constBits(), image.constBits() + image.sizeInBytes(), white.constBits()));
            }
    }

    void thePdfHasAllPages()
    {
        const QByteArray pdf = TagSheet(kId, core::tracking::cellsOf(kId)).pdf();
        QVERIFY(pdf.startsWith("%PDF"));
        QVERIFY(pdf.contains("/Count 3"));
    }
};

QTEST_MAIN(TestTagSheet)
#include "tst_tag_sheet.moc"
