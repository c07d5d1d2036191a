// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "core/tracking/PictureWatch.h"
#include "tests/support/Suite.h"

using namespace core::tracking;

namespace {

Picture noise(int level, unsigned seed)
{
    Picture picture;
    picture.width = 64;
    picture.height = 48;
    picture.pixels.resize(64 * 48);
    for (auto& pixel : picture.pixels) {
        seed = seed * 1664525U + 1013904223U;
        pixel = static_cast<std::uint8_t>(level + static_cast<int>(seed >> 30U));
    }
    return picture;
}

}  // namespace

class TestPictureWatch : public QObject
{
    Q_OBJECT
private slots:
    void picturesOfACameraAreFine()
    {
        PictureWatch watch;
        for (unsigned n = 0; n < 100; ++n)
            QVERIFY(watch.take(noise(60, n).view()) == PictureTrouble::None);
    }
    void darkAndBrightPicturesAreNoticedAfterAWhile_data()
    {
        QTest::addColumn<int>("level");
        QTest::addColumn<PictureTrouble>("expected");
        QTest::addRow("dark") << 1 << PictureTrouble::Dark;
        QTest::addRow("bright") << 250 << PictureTrouble::Bright;
    }
    void darkAndBrightPicturesAreNoticedAfterAWhile()
    {
        QFETCH(int, level);
        QFETCH(PictureTrouble, expected);
        PictureWatch watch;
        QVERIFY(watch.take(noise(level, 0).view()) == PictureTrouble::None);
        PictureTrouble last = PictureTrouble::None;
        for (unsigned n = 1; n < 60; ++n)
            last = watch.take(noise(level, n).view());
        QVERIFY(last == expected);
        QVERIFY(watch.take(noise(60, 1).view()) == PictureTrouble::None);
    }
    void theSamePictureAgainAndAgainIsFrozen()
    {
        PictureWatch watch;
        const Picture same = noise(60, 7);
        PictureTrouble last = PictureTrouble::None;
        for (int n = 0; n < 60; ++n)
            last = watch.take(same.view());
        QVERIFY(last == PictureTrouble::Frozen);
        QVERIFY(watch.take(noise(60, 8).view()) == PictureTrouble::None);
    }
};

CUSP_TEST(TestPictureWatch)
#include "tst_picture_watch.moc"
