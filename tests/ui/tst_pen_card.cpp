// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <QDoubleSpinBox>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QTabletEvent>
#include <QTest>

#include "tests/support/Suite.h"
#include "tests/ui/PageTest.h"
#include "ui/devices/DevicesPage.h"
#include "ui/devices/HandList.h"
#include "ui/devices/PenCard.h"
#include "ui/devices/PenField.h"

using core::settings::PenSettings;
using ui::devices::DevicesPage;
using ui::devices::HandList;
using ui::devices::PenCard;
using ui::devices::PenField;

class TestPenCard : public support::PageTest<DevicesPage>
{
    Q_OBJECT
private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        openPage();
        m_page->setChosen("pointer");
        m_page->show();
        card().setFullForce(0.8);
    }
    void cleanup() { m_window.reset(); }

    void itBelongsToMouseAndPen()
    {
        QVERIFY(card().isVisible());
        QCOMPARE(support::controlsWithoutNames(*m_window), QStringList());
        child<HandList>()->selectHand("simulated");
        QVERIFY(!card().isVisible());
    }

    void theFieldShowsPressureAndForce()
    {
        QVERIFY(words().contains("No pen"));
        send(QEvent::TabletMove, 0.0);
        QVERIFY(words().contains("hovers"));
        send(QEvent::TabletPress, 0.5);
        QVERIFY2(words().contains("50 %") && words().contains("0.40 N of 0.80 N"), qPrintable(words()));
        card().setSettings({2.0});
        QVERIFY(words().contains("0.20 N"));
        card().setFullForce(2.0);
        QVERIFY(words().contains("0.50 N of 2.00 N"));
        send(QEvent::TabletMove, std::numeric_limits<double>::quiet_NaN());
        QVERIFY(words().contains("hovers"));
        send(QEvent::TabletMove, 7.0);
        QVERIFY(words().contains("100 %"));
        send(QEvent::TabletRelease, 0.0);
        QVERIFY(words().contains("hovers"));
    }

    void aMouseIsNamed()
    {
        QTest::mouseClick(child<PenField>(), Qt::LeftButton);
        QVERIFY(words().contains("mouse") && words().contains("0.80 N"));
    }

    void theCurveIsChanged()
    {
        QSignalSpy changed(&card(), &PenCard::settingsChanged);
        card().setSettings({1.5});
        QCOMPARE(changed.count(), 0);
        QCOMPARE(child<QDoubleSpinBox>("penCurve")->value(), 1.5);
        child<QDoubleSpinBox>("penCurve")->setValue(2.5);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(changed.front().front().value<PenSettings>(), (PenSettings{2.5}));
    }

private:
    [[nodiscard]] PenCard& card() const { return m_page->pen(); }
    [[nodiscard]] QString words() const { return textOf("penWords"); }
    void send(QEvent::Type type, double pressure) const
    {
        const QPointingDevice pen(QStringLiteral("pen"), 1, QInputDevice::DeviceType::Stylus,
                                  QPointingDevice::PointerType::Pen, QInputDevice::Capability::Pressure, 1, 1);
        auto* const field = child<PenField>();
        const QPointF at = field->rect().center();
        const bool isDown = type != QEvent::TabletRelease && pressure != 0.0;
        QTabletEvent event(type, &pen, at, field->mapToGlobal(at), pressure, 0.0F, 0.0F, 0.0F, 0.0, 0.0F,
                           Qt::NoModifier, type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton,
                           isDown ? Qt::LeftButton : Qt::NoButton);
        QCoreApplication::sendEvent(field, &event);
        QVERIFY(event.isAccepted());
    }
};

CUSP_TEST(TestPenCard)
#include "tst_pen_card.moc"
