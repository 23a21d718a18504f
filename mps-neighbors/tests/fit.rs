//! Fitted points
use mps_kernel::Vector;
use mps_neighbors::Parallel;
use mps_neighbors::fit::*;
use std::time::Instant;

type V = Vector<f64, 2>;
struct Poly(Vec<[f64; 2]>);
impl Shape<2> for Poly {
    fn bounds(&self) -> [V; 2] {
        let p: Vec<V> = self.0.iter().map(|p| V::from(*p)).collect();
        [p.iter().fold(p[0], |a, b| a.inf(b)), p.iter().fold(p[0], |a, b| a.sup(b))]
    }
    fn nearest(&self, r: &V) -> Option<Nearest<2>> {
        let mut best = (f64::INFINITY, V::zeros());
        let mut inside = false;
        for k in 0..self.0.len() {
            let (a, b) = (V::from(self.0[k]), V::from(self.0[(k + 1) % self.0.len()]));
            let d = b - a;
            let q = a + d * ((r - a).dot(&d) / d.norm_squared()).clamp(0.0, 1.0);
            if (r - q).norm() < best.0 {
                best = ((r - q).norm(), q)
            }
            if (a.y > r.y) != (b.y > r.y) && r.x < a.x + d.x * (r.y - a.y) / d.y {
                inside = !inside
            }
        }
        Some(Nearest { foot: best.1, depth: if inside { best.0 } else { -best.0 } })
    }
}
fn ngon(n: usize, a: f64, b: f64, t: f64) -> Poly {
    Poly(
        (0..n)
            .map(|k| {
                let f = 6.283185307179586 * k as f64 / n as f64;
                let (x, y) = (a * f.cos(), b * f.sin());
                [x * t.cos() - y * t.sin(), x * t.sin() + y * t.cos()]
            })
            .collect(),
    )
}
fn rbox(w: f64, h: f64, t: f64) -> Poly {
    Poly(
        [[0., 0.], [w, 0.], [w, h], [0., h]]
            .map(|[x, y]| [x * t.cos() - y * t.sin(), x * t.sin() + y * t.cos()])
            .to_vec(),
    )
}
struct Ball(f64);
impl Shape<3> for Ball {
    fn bounds(&self) -> [Vector<f64, 3>; 2] {
        [Vector::repeat(-self.0), Vector::repeat(self.0)]
    }
    fn nearest(&self, r: &Vector<f64, 3>) -> Option<Nearest<3>> {
        Some(Nearest { foot: r.normalize() * self.0, depth: self.0 - r.norm() })
    }
}
fn report<const D: usize>(name: &str, shape: &impl Shape<D>, l0: f64) {
    let t = Instant::now();
    let f = match fit(shape, l0, &Parallel::serial()) {
        Ok(f) => f,
        Err(e) => {
            println!("{name}: {e}");
            return;
        }
    };
    let t = t.elapsed().as_secs_f64();
    let p = &f.places;
    let depth: Vec<f64> = p.iter().map(|p| shape.nearest(p).unwrap().depth / l0).collect();
    let w = |r: f64| {
        let s = (1.0 - r / 3.0f64).max(0.0);
        s * s * s * s * (4.0 * r / 3.0 + 1.0)
    };
    let n0: f64 = (0..7usize.pow(D as u32))
        .map(|mut k| {
            let r: f64 = (0..D)
                .map(|_| {
                    let x = (k % 7) as f64 - 3.0;
                    k /= 7;
                    x * x
                })
                .sum();
            w(r.sqrt())
        })
        .sum();
    let (mut nn_min, mut nn_max, mut dmin, mut dmax, mut layer, mut lay) =
        (9.0f64, 0.0f64, 9.0f64, 0.0f64, 0, vec![]);
    let mut sq = 0.0;
    let mut cnt = 0;
    for i in 0..p.len() {
        let mut nn = 9.0f64;
        let mut s = 0.0;
        let mut two = vec![];
        for j in 0..p.len() {
            let r = (p[i] - p[j]).norm() / l0;
            if r < 3.0 {
                s += w(r)
            }
            if i != j && r < nn {
                nn = r
            }
            if i != j && depth[j] < 0.6 && r < 3.0 {
                two.push(r)
            }
        }
        nn_min = nn_min.min(nn);
        nn_max = nn_max.max(nn);
        if depth[i] > 3.0 {
            dmin = dmin.min(s / n0);
            dmax = dmax.max(s / n0);
            sq += (s / n0 - 1.0).powi(2);
            cnt += 1
        }
        if depth[i] < 0.501 {
            layer += 1
        }
        if depth[i] < 0.6 {
            two.sort_by(f64::total_cmp);
            lay.push(two.get(1).copied().unwrap_or(9.0));
        }
    }
    let mid = depth.iter().filter(|d| **d > 0.501 && **d < 1.1).count();
    lay.sort_by(f64::total_cmp);
    let q = |f: f64| lay[((lay.len() - 1) as f64 * f) as usize];
    println!(
        "{name:>10}: {} points, {} sweeps, {t:.2} s, nn {nn_min:.3}..{nn_max:.3}, n/n0 {dmin:.3}..{dmax:.3} rms {:.4}, layer {layer}, between {mid}, 2nd along {:.2} {:.2} {:.2}",
        p.len(),
        f.sweeps,
        (sq / cnt.max(1) as f64).sqrt(),
        q(0.0),
        q(0.5),
        q(1.0)
    );
}
#[test]
fn trial() {
    let l0 = 0.05;
    report("box", &rbox(1.0, 0.5, 0.0), l0);
    report("odd box", &rbox(1.03, 0.52, 0.0), l0);
    report("inclined", &rbox(1.0, 0.5, 0.5), l0);
    report("beam", &rbox(1.0, 0.2, 0.3), l0);
    report("circle", &ngon(360, 0.5, 0.5, 0.0), l0);
    report("ellipse", &ngon(360, 0.8, 0.4, 0.4), l0);
    report("L", &Poly(vec![[0., 0.], [1., 0.], [1., 0.4], [0.4, 0.4], [0.4, 1.0], [0., 1.0]]), l0);
    report("triangle", &Poly(vec![[0., 0.], [1., 0.], [0.3, 0.8]]), l0);
    report("wedge", &Poly(vec![[0., 0.], [1., 0.], [1.0, 0.4]]), l0);
    report("big", &ngon(100, 1.5, 0.8, 0.4), 0.02);
    report("ball", &Ball(0.5), 0.08);
}
