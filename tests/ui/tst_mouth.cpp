// SPDX-License-Identifier: GPL-3.0-or-later
#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/OpenGlMain.h"
#include "tests/ui/Pictures.h"
#include "ui/render/Gizmo.h"
#include "ui/text/Texts.h"
#include "ui/toothchooser/Mouth.h"

using ui::toothchooser::Mouth;

class TestMouth : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        QVERIFY(Mouth::isPossible());
        m_mouth = std::make_unique<Mouth>(nullptr);
        m_mouth->resize(900, 700);
        m_mouth->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_mouth.get()));
        m_mouth->setFocus();
        QTRY_VERIFY_WITH_TIMEOUT(m_mouth->isReady(), 20000);
    }

    void cleanup()
    {
        pictures::keep(m_mouth->grabPicture(), QStringLiteral("mouth_") + QTest::currentTestFunction());
        m_mouth.reset();
    }

    void aClickChoosesALeftTooth()
    {
        QSignalSpy chosen(m_mouth.get(), &Mouth::selectionChanged);
        for (const int fdi : {36, 34, 32, 23, 21})
            QCOMPARE(clicked(at(fdi)), fdi);
        QCOMPARE(chosen.count(), 5);
        // A click beside the teeth does not change the selection.
        QCOMPARE(clicked({5, 350}), 21);
    }

    void aRightToothIsNamedButNotChosen()
    {
        m_mouth->setSelected(36);
        QTest::mouseMove(m_mouth.get(), at(42));
        QTRY_COMPARE(m_mouth->hovered(), 42);
        QCOMPARE(clicked(at(42)), 36);
        m_mouth->setSelected(46);
        QCOMPARE(m_mouth->selected(), 0);
    }

    void keysWalkAlongTheArch()
    {
        for (const auto& [key, fdi] : {std::pair(Qt::Key_Right, 21),
                                       {Qt::Key_Right, 22},
                                       {Qt::Key_Down, 32},
                                       {Qt::Key_Left, 31},
                                       {Qt::Key_Left, 31},
                                       {Qt::Key_Up, 21}})
            QCOMPARE(pressed(key), fdi);
        QCOMPARE(pressed(Qt::Key_Right, {}, 9), 28);
    }

    void doubleClickAndEnterTakeTheTooth()
    {
        QSignalSpy taken(m_mouth.get(), &Mouth::toothActivated);
        pressed(Qt::Key_Return);
        QCOMPARE(taken.count(), 0);
        QTest::mouseDClick(m_mouth.get(), Qt::LeftButton, {}, at(35));
        QCOMPARE(taken.count(), 1);
        QCOMPARE(taken.back().front().toInt(), 35);
        pressed(Qt::Key_Right);
        pressed(Qt::Key_Return);
        QCOMPARE(taken.count(), 2);
        QCOMPARE(taken.back().front().toInt(), m_mouth->selected());
    }

    void withLessMotionAZoomIsThereAtOnce()
    {
        const double before = m_mouth->camera().distanceMm();
        m_mouth->setMovesLittle(true);
        pressed(Qt::Key_Plus);
        const double after = m_mouth->camera().distanceMm();
        QVERIFY(after < 0.95 * before);
        // With animations, the camera moves gradually to the same place.
        pressed(Qt::Key_Home);
        m_mouth->setMovesLittle(false);
        pressed(Qt::Key_Plus);
        QVERIFY(m_mouth->camera().distanceMm() > after);
        QTRY_COMPARE(m_mouth->camera().distanceMm(), after);
    }

    void theJawInTheWayIsLeftOut()
    {
        QVERIFY(shows(26) && shows(36));
        pressed(Qt::Key_Up, Qt::ControlModifier, 8);
        QVERIFY(!shows(26) && shows(36));
        QCOMPARE(clicked(at(37)), 37);
        pressed(Qt::Key_Down, Qt::ControlModifier, 18);
        QVERIFY(!shows(36));
        QCOMPARE(clicked(at(26)), 26);
        pressed(Qt::Key_Home);
        QVERIFY(shows(26) && shows(36));
    }

    void hiddenJawComesBackForTheKeys()
    {
        m_mouth->setSelected(36);
        pressed(Qt::Key_Up, Qt::ControlModifier, 10);
        QCOMPARE(pressed(Qt::Key_Up), 26);
        QVERIFY(shows(26));
        pressed(Qt::Key_Down, Qt::ControlModifier, 10);
        QCOMPARE(pressed(Qt::Key_Down), 36);
        QVERIFY(shows(36));
    }

    void gizmoPutsLettersWhereTheSidesAre()
    {
        const auto paint = [](const ui::render::GizmoLetters& letters) {
            QImage image(200, 200, QImage::Format_RGB32);
            image.fill(Qt::black);
            QPainter painter(&image);
            ui::render::paintGizmo(painter, {100, 100}, 90, glm::dmat3(1.0), letters);
            return image;
        };
        // Seen from above with +x to the right: distal right, +y up, occlusal in the middle.
        const QImage none = paint({});
        const auto box = [&](std::size_t end) {
            ui::render::GizmoLetters one;
            one.at(end) = QStringLiteral("X");
            return pictures::difference(none, paint(one), 40).box;
        };
        QVERIFY(box(0).left() < 60 && box(0).right() <= 102);
        QVERIFY(box(1).right() > 140 && box(1).left() >= 98);
        QVERIFY(box(3).top() < 60 && box(3).bottom() <= 102);
        QVERIFY(box(5).contains(100, 100) && box(5).width() < 60);
        QVERIFY(pictures::difference(none, paint({"M", "D", "L", "B", "", "O"}), 40).pixels > 1000);
        pictures::keep(paint({"M", "D", "L", "B", "", "O"}), QStringLiteral("gizmo"));
    }

    void lettersFollowTheTooth()
    {
        QCOMPARE(ui::text::surfaceLetters(36), QStringList({"M", "D", "B", "L", "", "O"}));
        QCOMPARE(ui::text::surfaceLetters(26), QStringList({"M", "D", "P", "B", "", "O"}));
        QCOMPARE(ui::text::surfaceLetters(21), QStringList({"M", "D", "P", "La", "", "I"}));
        QVERIFY(ui::text::surfaceLetters(0).isEmpty());
    }

private:
    [[nodiscard]] QPoint at(int fdi) const { return m_mouth->placeOf(fdi).toPoint(); }
    [[nodiscard]] bool shows(int fdi) const { return !at(fdi).isNull(); }

    /// Clicks a point and returns the selected tooth.
    int clicked(QPoint place)
    {
        QTest::mouseClick(m_mouth.get(), Qt::LeftButton, {}, place);
        return m_mouth->selected();
    }

    int pressed(Qt::Key key, Qt::KeyboardModifiers with = {}, int times = 1)
    {
        for (int k = 0; k < times; ++k)
            QTest::keyClick(m_mouth.get(), key, with);
        return m_mouth->selected();
    }

    std::unique_ptr<Mouth> m_mouth;
};

int main(int argc, char** argv)
{
    return support::openGlMain<TestMouth>(argc, argv);
}
#include "tst_mouth.moc"
