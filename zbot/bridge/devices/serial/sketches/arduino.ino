// Prints a temperature every second. Switches the LED of the board.
//
// On your computer:  zbot serial --to /led:std_msgs/msg/Bool
//                    zbot topic echo /temperature
//                    zbot topic pub --once /led std_msgs/msg/Bool "data: true"

const unsigned long INTERVAL_MS = 1000;
unsigned long lastPrint = 0;

// Put your sensor here, e.g. an analog sensor at the pin A0.
float readTemperature() {
  return analogRead(A0) * 0.1;
}

// A line from the computer is a name and a value: "led: 1".
void handleLine(const String &line) {
  int colon = line.indexOf(':');
  if (colon < 0) {
    return;
  }
  String name = line.substring(0, colon);
  String value = line.substring(colon + 1);
  if (name == "led") {
    digitalWrite(LED_BUILTIN, value.toInt() ? HIGH : LOW);
  }
}

void setup() {
  Serial.begin(115200);
  Serial.setTimeout(50);
  pinMode(LED_BUILTIN, OUTPUT);
}

void loop() {
  if (Serial.available()) {
    handleLine(Serial.readStringUntil('\n'));
  }
  if (millis() - lastPrint >= INTERVAL_MS) {
    lastPrint = millis();
    // The name is the topic. A line ends with println().
    Serial.print("temperature: ");
    Serial.println(readTemperature());
  }
}
