// Calls of roslibjs against a running turtlesim. `callAll` returns the outcome of each by name.

const PATIENCE_MS = 15000;

function within(promise, what) {
  const late = new Promise((_, fail) => setTimeout(() => fail(`no ${what}`), PATIENCE_MS));
  return Promise.race([promise, late]);
}

function expect(condition, found) {
  if (!condition) throw `found ${JSON.stringify(found)}`;
}

function open(ROSLIB, url) {
  const ros = new ROSLIB.Ros({ url });
  const done = new Promise((succeed, fail) => {
    ros.on("connection", () => succeed(ros));
    ros.on("error", () => fail("no connection"));
  });
  return within(done, "connection");
}

// Call a function of roslibjs that takes callbacks for the result and for an error last.
function ask(object, name, ...given) {
  return within(new Promise((done, fail) => object[name](...given, done, fail)), "answer");
}

function call(ROSLIB, ros, name, serviceType, request) {
  return ask(new ROSLIB.Service({ ros, name, serviceType }), "callService", request);
}

// Subscribe, and return the first message that fits.
function message(ROSLIB, ros, options, fits = () => true) {
  const topic = new ROSLIB.Topic({ ros, ...options });
  const found = new Promise((done) => topic.subscribe((one) => fits(one) && done(one)));
  return within(found, `message on ${options.name}`).finally(() => topic.unsubscribe());
}

const POSE = { name: "/turtle1/pose", messageType: "turtlesim/Pose" };
const TWIST = { name: "/turtle1/cmd_vel", messageType: "geometry_msgs/Twist" };
const ROTATE = { name: "/turtle1/rotate_absolute", actionType: "turtlesim/action/RotateAbsolute" };

const CALLS = {
  async getTopics(ROSLIB, ros) {
    const found = await ask(ros, "getTopics");
    const index = found.topics.indexOf("/turtle1/pose");
    expect(found.types[index] === "turtlesim/msg/Pose", found);
  },
  async getTopicsForType(ROSLIB, ros) {
    const found = await ask(ros, "getTopicsForType", "turtlesim/msg/Pose");
    expect(found.includes("/turtle1/pose"), found);
  },
  async getTopicType(ROSLIB, ros) {
    const found = await ask(ros, "getTopicType", "/turtle1/pose");
    expect(found === "turtlesim/msg/Pose", found);
  },
  async getTopicsAndRawTypes(ROSLIB, ros) {
    const found = await ask(ros, "getTopicsAndRawTypes");
    const index = found.topics.indexOf("/turtle1/pose");
    expect(/float32 theta/.test(found.typedefs_full_text[index]), found);
  },
  async getServices(ROSLIB, ros) {
    const found = await ask(ros, "getServices");
    expect(found.includes("/spawn"), found);
  },
  async getServicesForType(ROSLIB, ros) {
    const found = await ask(ros, "getServicesForType", "turtlesim/srv/Spawn");
    expect(found.includes("/spawn"), found);
  },
  async getServiceType(ROSLIB, ros) {
    const found = await ask(ros, "getServiceType", "/spawn");
    expect(found === "turtlesim/srv/Spawn", found);
  },
  async getServiceRequestDetails(ROSLIB, ros) {
    const found = await ask(ros, "getServiceRequestDetails", "turtlesim/srv/Spawn");
    expect(found.typedefs[0].fieldnames.includes("theta"), found);
  },
  async getServiceResponseDetails(ROSLIB, ros) {
    const found = await ask(ros, "getServiceResponseDetails", "turtlesim/srv/Spawn");
    expect(found.typedefs[0].fieldnames.includes("name"), found);
  },
  async getMessageDetails(ROSLIB, ros) {
    const found = ros.decodeTypeDefs(await ask(ros, "getMessageDetails", "geometry_msgs/Twist"));
    expect(JSON.stringify(Object.keys(found)) === '["linear","angular"]', found);
  },
  async getNodes(ROSLIB, ros) {
    const found = await ask(ros, "getNodes");
    expect(found.includes("/turtlesim"), found);
  },
  async getNodeDetails(ROSLIB, ros) {
    const found = await within(
      new Promise((done, fail) =>
        ros.getNodeDetails.length === 2
          ? ros.getNodeDetails("/turtlesim", done, fail)
          : ros.getNodeDetails("/turtlesim", (...lists) => done(lists), fail)
      ),
      "answer"
    );
    expect(JSON.stringify(found).includes("/turtle1/pose"), found);
  },
  async getActionServers(ROSLIB, ros) {
    const found = await ask(ros, "getActionServers");
    expect(found.includes("/turtle1/rotate_absolute"), found);
  },
  async getParams(ROSLIB, ros) {
    const found = await ask(ros, "getParams");
    expect(found.includes("/turtlesim:background_r"), found);
  },
  async "Param.get and set"(ROSLIB, ros) {
    const param = new ROSLIB.Param({ ros, name: "/turtlesim:background_r" });
    const before = await ask(param, "get");
    expect(Number.isInteger(before), before);
    await ask(param, "set", 7);
    const after = await ask(param, "get");
    await ask(param, "set", before);
    expect(after === 7, after);
  },
  async "Topic.subscribe"(ROSLIB, ros) {
    const found = await message(ROSLIB, ros, POSE);
    expect(typeof found.theta === "number", found);
  },
  async "Topic.subscribe, throttled"(ROSLIB, ros) {
    const times = [];
    const options = { ...POSE, throttle_rate: 300, queue_length: 1 };
    await message(ROSLIB, ros, options, () => times.push(performance.now()) === 5);
    expect(times[4] - times[0] > 600, times); // 1200 ms, less if the first one was late
  },
  async "Topic.subscribe, png"(ROSLIB, ros) {
    const found = await message(ROSLIB, ros, { ...POSE, compression: "png" });
    expect(typeof found.theta === "number", found);
  },
  async "Topic.subscribe, cbor"(ROSLIB, ros) {
    const found = await message(ROSLIB, ros, { ...POSE, compression: "cbor" });
    expect(typeof found.theta === "number", found);
  },
  async "Topic.subscribe, cbor, arrays"(ROSLIB, ros) {
    const options = { name: "/array_of_floats", messageType: "std_msgs/Float32MultiArray" };
    const topic = new ROSLIB.Topic({ ros, ...options, latch: true });
    topic.publish({ data: [1.5, -2] });
    const found = await message(ROSLIB, ros, { ...options, compression: "cbor" });
    topic.unadvertise();
    expect(found.data instanceof Float32Array && found.data[1] === -2, found);
  },
  async "Topic.subscribe, cbor-raw"(ROSLIB, ros) {
    // Version 1 decodes a picture later. So the last one may come now, as a message without bytes.
    const options = { ...POSE, compression: "cbor-raw" };
    const found = await message(ROSLIB, ros, options, (one) => one.bytes);
    expect(found.bytes.length >= 20 && found.secs > 0, found);
  },
  async "Topic.publish"(ROSLIB, ros) {
    const topic = new ROSLIB.Topic({ ros, ...TWIST });
    const moved = message(ROSLIB, ros, POSE, (pose) => pose.linear_velocity > 0);
    const timer = setInterval(() => topic.publish({ linear: { x: 1 } }), 100);
    await moved.finally(() => clearInterval(timer));
    topic.unadvertise();
  },
  async "Topic.publish, octets"(ROSLIB, ros) {
    const options = { name: "/octets", messageType: "std_msgs/UInt8MultiArray" };
    const topic = new ROSLIB.Topic({ ros, ...options, latch: true });
    topic.publish({ data: btoa("\x00\x01\xff") });
    const found = await message(ROSLIB, ros, options);
    topic.unadvertise();
    expect(found.data === btoa("\x00\x01\xff"), found);
  },
  async "Service.callService"(ROSLIB, ros) {
    const request = { x: 2, y: 2.5, theta: 0, name: "" };
    const found = await call(ROSLIB, ros, "/spawn", "turtlesim/srv/Spawn", request);
    expect(/^turtle\d+$/.test(found.name), found);
    await call(ROSLIB, ros, "/kill", "turtlesim/srv/Kill", { name: found.name });
  },
  async "Service.callService, an error"(ROSLIB, ros) {
    const error = await call(ROSLIB, ros, "/spawn", "turtlesim/srv/Spawn", { x: "left" }).then(
      (answer) => ({ answer }),
      (reason) => String(reason)
    );
    expect(typeof error === "string" && error.includes("x"), error);
  },
  async "Service.advertise"(ROSLIB, ros, url) {
    const facts = { name: "/set_from_page", serviceType: "std_srvs/SetBool" };
    const service = new ROSLIB.Service({ ros, ...facts });
    service.advertise((request, response) => {
      response.success = request.data;
      response.message = "from the page";
      return true;
    });
    const other = await open(ROSLIB, url);
    try {
      const names = () => ask(other, "getServices");
      while (!(await names()).includes(facts.name)) continue;
      const found = await call(ROSLIB, other, facts.name, facts.serviceType, { data: true });
      expect(found.success && found.message === "from the page", found);
    } finally {
      service.unadvertise();
      other.close();
    }
  },
  async "Action.sendGoal, feedback and result"(ROSLIB, ros) {
    const action = new ROSLIB.Action({ ros, ...ROTATE });
    const feedback = [];
    const result = await within(
      new Promise((done, fail) =>
        action.sendGoal({ theta: 1.5 }, done, (one) => feedback.push(one), fail)
      ),
      "result"
    );
    expect(typeof result.delta === "number", result);
    expect(typeof feedback[0]?.remaining === "number", feedback);
  },
  async "Action.cancelGoal"(ROSLIB, ros) {
    const action = new ROSLIB.Action({ ros, ...ROTATE });
    let id;
    const outcome = await within(
      new Promise((done) => {
        const cancel = () => action.cancelGoal(id);
        id = action.sendGoal({ theta: -1.5 }, () => done("result"), cancel, done);
      }),
      "result"
    );
    expect(/cancel|5/i.test(String(outcome)), String(outcome));
  },
  async "Action.advertise"(ROSLIB, ros, url) {
    const facts = { name: "/count", actionType: "example_interfaces/action/Fibonacci" };
    const server = new ROSLIB.Action({ ros, ...facts });
    server.advertise(
      (goal, id) => {
        server.sendFeedback(id, { sequence: [0] });
        server.setSucceeded(id, { sequence: [0, goal.order] });
      },
      () => {}
    );
    const other = await open(ROSLIB, url);
    try {
      while (!(await ask(other, "getActionServers")).includes(facts.name)) continue;
      const client = new ROSLIB.Action({ ros: other, ...facts });
      const result = await within(
        new Promise((done, fail) => client.sendGoal({ order: 5 }, done, () => {}, fail)),
        "result"
      );
      expect(result.sequence[1] === 5, result);
    } finally {
      server.unadvertise();
      other.close();
    }
  },
  async "status of a wrong message"(ROSLIB, ros) {
    const status = within(new Promise((done) => ros.on("status:wrong", done)), "status");
    const other = within(new Promise((done) => ros.on("status", done)), "status");
    ros.callOnConnection({ op: "subscribe", id: "wrong", topic: "/nobody_uses_this" });
    const found = await Promise.race([status, other]);
    status.catch(() => {});
    other.catch(() => {});
    expect(found.level === "error", found);
  },
};

export async function callAll(ROSLIB, url, only = null) {
  const outcomes = {};
  const ros = await open(ROSLIB, url);
  for (const [name, one] of Object.entries(CALLS)) {
    if (only !== null && !only.includes(name)) continue;
    if (name.startsWith("Action.") && !ROSLIB.Action) continue; // version 1 has ROS 1's actions
    try {
      await within(one(ROSLIB, ros, url), "end");
      outcomes[name] = "ok";
    } catch (error) {
      outcomes[name] = String(error);
    }
  }
  ros.close();
  return outcomes;
}
