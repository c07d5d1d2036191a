// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticMolar.h"
#include "ui/kit/Actions.h"
#include "ui/kit/Theme.h"
#include "ui/tooth/ToothView.h"
#include "ui/toothchooser/ArchView.h"
#include "ui/toothchooser/Mouth.h"
#include "ui/window/MainWindow.h"

using ui::tooth::ToothView;

/// The tooth view on a platform without OpenGL, such as Qt's "offscreen".
class TestToothViewWithoutOpenGl : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { ui::kit::applyTheme(*qApp, ui::kit::ThemeChoice::Light); }

    void init()
    {
        QTest::ignoreMessage(QtWarningMsg,
                             QRegularExpression("No picture of a tooth can be drawn: no context of version 3.3"));
    }

    void aWindowSaysWhatIsMissingAndWhatToDo()
    {
        core::session::UiChannels links;
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* view = new ToothView(links);
        layout->addWidget(view);
        window.resize(400, 300);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(!view->isUsable());
        const auto* label = window.findChild<QLabel*>("whyNot");
        QVERIFY(label != nullptr && label->isVisible());
        QVERIFY(label->text().contains("OpenGL 3.3") && label->text().contains("driver"));
        // Dark like the room around it, also in a light theme, and legible at arm's length.
        const QImage picture = view->picture();
        QCOMPARE(picture.pixelColor(2, 2), ui::kit::roomPalette().color(QPalette::Window));
        QVERIFY(ui::kit::contrast(label->palette().color(label->foregroundRole()), picture.pixelColor(2, 2)) >= 4.5);
        QVERIFY(label->font().pixelSize() >= ui::kit::kBody);
        QVERIFY(label->height() >= label->heightForWidth(label->width()));
        // Drilling is not possible without a view of the tooth.
        QTest::mousePress(view, Qt::LeftButton);
        QVERIFY(!links.pointer.latest().pushing);
    }

    void everythingElseStillAnswers()
    {
        core::session::UiChannels links;
        ToothView view(links);
        QSignalSpy frames(&view, &ToothView::frameAdvanced);
        view.setTooth(support::syntheticMolar(64), 1);
        view.setLeftHanded(true);
        view.setCamera(10.0, 40.0, 30.0);
        view.setPushForce(2.0);
        QCOMPARE(links.pointer.latest().pushForceN, 2.0);
        core::servo::TilePatch patch;
        patch.toothGeneration = 1;
        patch.last = true;
        patch.top.fill(-4.0F);
        QVERIFY(links.patches.tryPush(patch));
        QTRY_VERIFY(frames.count() > 2);
        QVERIFY(!links.patches.tryPop(patch));
    }

    void theWholeMouthIsNotOffered()
    {
        QVERIFY(!ui::toothchooser::Mouth::isPossible());
        core::session::UiChannels links;
        ui::window::MainWindow window(links);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        const auto* actions = window.findChild<ui::kit::Actions*>();
        QVERIFY(!actions->mouth->isVisible());
        QVERIFY(!actions->mouth->isEnabled());
        // The flat arches are still available, and no button leads to the missing view.
        actions->chooseTooth->trigger();
        QVERIFY(window.findChild<ui::toothchooser::ArchView*>()->isVisible());
        for (const QPushButton* button : window.findChildren<QPushButton*>())
            QVERIFY(!button->isVisible() || button->text() != actions->mouth->text());
    }
};

CUSP_TEST(TestToothViewWithoutOpenGl)
#include "tst_tooth_view_without_opengl.moc"
