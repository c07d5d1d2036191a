// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <QImage>
#include <QtTest>

#include "lessons/LessonCatalog.h"
#include "tests/support/Suite.h"
#include "ui/catalog/LessonPicture.h"

using lessons::Lesson;
using ui::catalog::LessonPicture;

namespace {

int differingDots(const QImage& a, const QImage& b)
{
    int dots = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            dots += a.pixel(x, y) == b.pixel(x, y) ? 0 : 1;
    return dots;
}

/// Returns the number of pixels in the colour of decay.
int countBrown(const QImage& image)
{
    int dots = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor dot(image.pixel(x, y));
            dots += dot.red() > dot.blue() + 30 && dot.lightness() < 110 ? 1 : 0;
        }
    }
    return dots;
}

/// Returns whether two pictures are equal except for a few pixels, because hatched lines may differ slightly.
bool alike(const QImage& a, const QImage& b)
{
    constexpr int kMostDots = 60;
    return differingDots(a, b) <= kMostDots;
}

}  // namespace

/// The preview of a lesson.
class TestLessonPicture : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_picture = std::make_unique<LessonPicture>(nullptr);
        m_picture->resize(640, 300);
    }

    void cleanup() { m_picture.reset(); }
    void eachTaskHasItsPicture()
    {
        QList<QImage> all;
        for (const char* id : {"orientation-1-touch", "orientation-2-hold", "block-dovetail", "decay-36-small",
                               "class1-36", "class2-36-distal", "access-36"}) {
            const QImage drawn = picture(named(id));
            QVERIFY2(std::none_of(all.begin(), all.end(), [&](const QImage& other) { return alike(other, drawn); }),
                     id);
            QVERIFY(m_picture->isVisible());
            all << drawn;
        }
    }

    void whatIsFeltIsNotShown()
    {
        picture(named("orientation-2-hold"));
        m_picture->setLesson(named("orientation-3-layers"));
        QVERIFY(!m_picture->isVisible() && !m_picture->isReady());
        m_picture->setLesson(named("class1-36"));
        QVERIFY(m_picture->isVisible());
        m_picture->setLesson({});
        QVERIFY(!m_picture->isVisible());
    }

    void theIdealIsShownToWhoMaySeeIt()
    {
        Lesson lesson = named("class1-36");
        const QImage told = picture(lesson);
        lesson.aids.section = false;
        lesson.hash = "without section";
        const QImage fromAbove = picture(lesson);
        lesson.aids.ideal = false;
        lesson.hash = "without ideal";
        const QImage bare = picture(lesson);
        QVERIFY(!alike(told, fromAbove) && !alike(fromAbove, bare));
        // Seen from above, open decay is visible whatever the aids are.
        Lesson decay = named("decay-36-deep");
        QVERIFY(countBrown(picture(decay)) > 100);
        QVERIFY(countBrown(m_picture->grab(QRect(330, 30, 300, 200)).toImage()) > 100);  // the section through it
        decay.aids = {};
        decay.aids.ideal = decay.aids.section = false;
        decay.hash = "without aids";
        QVERIFY(countBrown(picture(decay)) > 100);
        QCOMPARE(countBrown(m_picture->grab(QRect(330, 30, 300, 200)).toImage()), 0);
    }

    void theLastOfManyIsShown()
    {
        const QImage wanted = picture(named("class1-26"));
        for (const char* id : {"class1-36", "class1-37", "block-cross", "class1-24"})
            m_picture->setLesson(named(id));
        const QImage last = picture(named("class1-26"));
        QVERIFY2(alike(last, wanted), qPrintable(QStringLiteral("%1 dots").arg(differingDots(last, wanted))));
        QTest::qWait(300);  // the other pictures are made in this time, and none of them may be shown
        QVERIFY(alike(shown(), wanted));
    }

    void aToothThatCannotBeMadeIsSaid()
    {
        Lesson lesson = named("orientation-2-hold");
        const QImage tooth = picture(lesson);
        lesson.tooth = lessons::Scan{"/nowhere/at-all.stl", {}, {}, {}, 36, {}};
        lesson.hash = "scan";
        m_picture->setLesson(lesson);
        const QImage making = shown();
        QTRY_VERIFY_WITH_TIMEOUT(!alike(shown(), making), 30000);  // the text has changed
        QVERIFY(!m_picture->isReady() && m_picture->isVisible());
        QVERIFY(alike(picture(named("orientation-2-hold")), tooth));
    }

    void itMayGoWhileAToothIsMade()
    {
        m_picture->setLesson(named("class1-36"));
        m_picture.reset();
        QCoreApplication::processEvents();
    }

private:
    static Lesson named(const char* id) { return lessons::lessonNamed(QString::fromLatin1(id)).value(); }
    QImage picture(const Lesson& lesson)
    {
        m_picture->setLesson(lesson);
        if (!QTest::qWaitFor([this] { return m_picture->isReady(); }, 30000))
            qWarning("no picture of %s", lesson.id.c_str());
        return shown();
    }

    /// Returns the picture of the tooth from above, between the texts.
    [[nodiscard]] QImage shown() const { return m_picture->grab(QRect(0, 30, 310, 200)).toImage(); }

    std::unique_ptr<LessonPicture> m_picture;
};

CUSP_TEST(TestLessonPicture)
#include "tst_lesson_picture.moc"
